# Completes the command line of archard(1) in bash: options, example scripts, Lua scripts and run files.
_archard() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} i
  COMPREPLY=()
  case $before in
  -e | --memory | --seconds | --instructions) return ;;
  -l)
    mapfile -t COMPREPLY < <(compgen -f -X '!*.lua' -- "$word" | sed 's/\.lua$//')
    return
    ;;
  esac
  for ((i = 1; i < COMP_CWORD; i++)); do # the words after the script are its arguments
    case ${COMP_WORDS[i]} in
    -e | -l | --memory | --seconds | --instructions) i=$((i + 1)) ;;
    -?*) ;;
    *)
      mapfile -t COMPREPLY < <(compgen -f -- "$word")
      compopt -o filenames
      return
      ;;
    esac
  done
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" --help 2>/dev/null |
      grep -oE '^  -[^ ]+(, --[a-z]+)?' | tr -d ',')" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.lua' -- "$word"; compgen -d -- "$word")
    compopt -o filenames
  fi
}
complete -F _archard archard
