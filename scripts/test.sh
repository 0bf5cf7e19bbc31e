# SPDX-License-Identifier: Apache-2.0
#
# Part of the launcher `trammel`: its verb `test`.

misused() {
  say "$1"
  exit 2
}

# Lint, unit test and proof of blocks; nothing else is built. With options of ctest, ctest runs
# them.
test_blocks() {
  local words=() block tests=''
  while [ $# -gt 0 ] && [[ $1 != -* ]]; do
    words+=("$1")
    shift
  done
  for block in "$@"; do
    [[ $block != --@(full|full-only|campaign) ]] ||
      misused "$block: a tier has no blocks; --campaign -R ${words[0]/\//.} runs the mutants of one"
  done
  python3 "$root/scripts/tool" test-block --names "${words[@]}" || exit
  install_packages more test
  install_python_tools
  configure
  if [ $# -eq 0 ]; then
    exec "$python" "$root/scripts/tool" test-block "${words[@]}"
  fi
  for block in "${words[@]}"; do
    [ ! -f "$root/tests/${block}_test.cpp" ] || build_targets "${block#*/}_test"
  done
  for block in "${words[@]}"; do
    tests+="|(lint|unit|formal)\.${block/\//.}|formal\.leap\.(broken\.)?${block#*/}"
  done
  run_tests -R "^(${tests#|})\$" "$@"
}

# The tests of a tier: those without the label `full`, those with it, or both; or the campaigns,
# which CTest knows only as a configuration. Tests chosen by name, label or number are taken from
# all but the campaigns.
test_tier() {
  local tier=first chosen='' options=() word before=''
  [[ " $* " != *" --campaign "*  || " $* " != *" --full"?(-only)" "* ]] ||
    misused "--campaign: it is a tier of its own; run --full or --full-only in another command"
  for word in "$@"; do
    [[ $word == -* || $before == -* && $before != --@(full|full-only|campaign|fresh) ]] ||
      misused "$word: a block goes first and has no tier; -R NAME chooses tests of a tier by name"
    before=$word
    case $word in
      --full) [ "$tier" = full-only ] || tier=full ;;
      --full-only) tier=full-only ;;
      --campaign) tier=campaign ;;
      --fresh) export TRAMMEL_FRESH=1 ;;
      *) options+=("$word") ;;
    esac
    [[ $word != @(-R*|-L|-I*|--tests-*|--label-regex*|--rerun-failed) ]] || chosen=yes
  done
  install_packages more test
  install_python_tools
  case $tier in
    campaign) options+=(-C campaign -L '^campaign$') ;;
    full-only) options+=(-L '^full$') ;;
    first) [ -n "$chosen" ] || options+=(-LE '^full$') ;;
  esac
  configure
  local targets=(all)
  if [ "$tier" = campaign ]; then
    targets=(trammel trammel_catch_main)  # the rest they build themselves
  elif counts_coverage "${options[@]}"; then
    # shellcheck disable=SC2207  # names without blanks
    targets+=(trammel_full $("$python" "$root/scripts/tool" evidence --needed))
  fi
  build_targets "${targets[@]}"
  run_tests "${options[@]}"
}

# Not `grep -q`: it ends at the first line, and ctest by SIGPIPE.
counts_coverage() { (cd "$build" && ctest -N "$@") | grep '^ *Test .*: coverage\.' > /dev/null; }

run_tests() {
  local log=$build/test.log skipped code=0
  exec 8> "$build/.testing"
  flock -n 8 || { say "waiting: another test run uses this clone"; flock 8; }
  ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(nproc)" "$@" 8>&- 2>&1 |
    tee "$log" || code=$?
  skipped=$(sed -n 's/^[[:space:]]*[0-9]* - \(.*\) (Skipped)$/\1/p' "$log" | sort -u)
  if [ -n "$skipped" ]; then
    say "skipped, an optional tool is missing:"
    printf '  %s\n' $skipped >&2
    if [ "${CI:-}" = true ] && [ "$code" -eq 0 ]; then
      say "CI has all tools: a skipped test is a failure"
      return 1
    fi
  fi
  if grep -q '^No tests were found' "$log"; then
    say "no such test in this tier; \`trammel test --full -N\` and \`--campaign -N\` list all tests"
  fi
  if [ "$code" -ne 0 ]; then return 1; fi
}

test_usage() {
  cat << 'EOF'
Usage: trammel test [--full | --full-only | --campaign] [--fresh] [ctest options]
       trammel test layer/block ... [ctest options]

Installs what the tests need, builds, and runs the tests of the first tier: everything that checks
how the product behaves. One test per processor runs at a time.
  --full                      also whether the evidence is complete: sanitizers, proofs,
                              coverage, synthesis, some of each campaign
  --full-only                 that alone
  --campaign                  how good the tests are: whole campaigns of mutants, faults, keys,
                              sensitivity, random input, acceptance, speed, second Verilator.
                              They take hours; a result that holds is not made again, so the
                              command can be interrupted and called again
  --fresh                     checks again what has a kept result in evidence/
  drive/svpwm                 lint, unit test and proof of this block; nothing else is built

Options of ctest, for instance:
  -N                          list the tests
  -R drive.svpwm              those whose name matches, of --full too; with --campaign of that

Exit codes: 0 all passed, 1 a test or the build failed, 2 no such block or a wrong option, 3
something required is missing.
EOF
}
