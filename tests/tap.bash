# Sourced by tests in bash: TAP lines from comparisons.
#   is WHAT GOT EXPECTED        equal text
#   like WHAT GOT PATTERN       the extended regular expression matches somewhere
#   unlike WHAT GOT PATTERN
#   finish                      prints the plan; its status is the test's
ARCHARD=${ARCHARD:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build/archard}
tap_count=0
tap_failed=0

tap_result() { # yes|no WHAT
  tap_count=$((tap_count + 1))
  if [ "$1" = yes ]; then
    echo "ok $tap_count - $2"
  else
    tap_failed=$((tap_failed + 1))
    echo "not ok $tap_count - $2"
  fi
}

is() {
  if [ "$2" = "$3" ]; then tap_result yes "$1"; else
    tap_result no "$1"
    printf 'got:\n%s\nexpected:\n%s\n' "$2" "$3" | sed 's/^/# /'
  fi
}

like() {
  if grep -Eq -- "$3" <<<"$2"; then tap_result yes "$1"; else
    tap_result no "$1"
    printf 'got:\n%s\nexpected something like: %s\n' "$2" "$3" | sed 's/^/# /'
  fi
}

unlike() {
  if ! grep -Eq -- "$3" <<<"$2"; then tap_result yes "$1"; else
    tap_result no "$1"
    printf 'got:\n%s\nexpected nothing like: %s\n' "$2" "$3" | sed 's/^/# /'
  fi
}

finish() {
  echo "1..$tap_count"
  [ $tap_failed -eq 0 ]
}
