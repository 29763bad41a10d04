#compdef archard
# Completes the command line of archard(1) in zsh: the options that the program lists with --help, scripts and
# files.
local -a flags
local line
for line in ${(f)"$($words[1] --help 2>/dev/null)"}; do
  [[ $line =~ '^  -([^ ,]+)(, (--[a-z]+))?( [A-Z]+)? +(.*)$' ]] || continue
  case -$match[1] in
  -e) flags+=('*-e[run a Lua text]:Lua text: ') ;;
  -l) flags+=('*-l[require a module]:module:_files -g "*.lua(\:r)"') ;;
  --memory|--seconds|--instructions) flags+=("-${match[1]}[${match[5]}]:number: ") ;;
  -|--) ;;
  *)
    flags+=("-${match[1]}[${match[5]}]")
    [[ -z $match[3] ]] || flags+=("${match[3]}[${match[5]}]")
    ;;
  esac
done
_arguments -S $flags '1:script:_files -g "*.lua"' '*:argument:_files'
