# Sourced by tests in expect: a session at the prompt of archard, and TAP lines.
#   start ?name value ...?    starts a session, with these environment variables
#   type text                 types text, and Enter
#   keys text                 types text alone
#   sees what pattern         ok when the pattern (of expect, "glob") comes
#   sees_re what expression   the same with a regular expression
#   never what pattern        ok when the pattern has not come by the next prompt
#   finish
log_user 0
set timeout 60
set count 0
set failed 0
set columns 80

proc result {passed what} {
  global count failed
  incr count
  if {$passed} {
    puts "ok $count - $what"
  } else {
    incr failed
    puts "not ok $count - $what"
    set seen [string map {"\x1b" "<ESC>" "\r" "" "\n" "\n#   "} $::expect_out(buffer)]
    puts "#   ...$seen"
  }
}

proc start {args} {
  global env spawn_id columns
  array set settings {TERM xterm NO_COLOR 1 LC_ALL C.UTF-8 INPUTRC /dev/null}
  array set settings $args
  set command [list env]
  foreach {name value} [array get settings] { lappend command "$name=$value" }
  set ::stty_init "rows 40 columns $columns"
  spawn {*}$command $env(ARCHARD)
  expect "> "
}

# Ends the session by Ctrl-D, and waits for it. Only a prompt that is there takes it: before, the
# terminal would keep it as the end of a line.
proc leave {} {
  answers
  send "\004"
  expect eof
  return [lindex [wait] 3]
}

proc keys {text} { send -- $text }
proc type {text} { send -- "$text\r" }

proc sees {what pattern} {
  set ::expect_out(buffer) "(nothing)"
  expect {
    -ex $pattern { result 1 $what }
    eof { result 0 "$what (the session ended)" }
    timeout { result 0 "$what (no sign of: $pattern)" }
  }
}

proc sees_re {what expression} {
  set ::expect_out(buffer) "(nothing)"
  expect {
    -re $expression { result 1 $what }
    eof { result 0 "$what (the session ended)" }
    timeout { result 0 "$what (no sign of: $expression)" }
  }
}

# Types a line that shows when all before it has been answered, and returns what came until then.
proc answers {} {
  send "'<' .. 'done' .. '>'\r"
  expect "<done>\r\n*> "
  return $::expect_out(buffer)
}

proc never {what pattern} {
  result [expr {[string first $pattern [answers]] < 0}] $what
}

proc finish {} {
  global count failed
  puts "1..$count"
  exit [expr {$failed > 0}]
}
