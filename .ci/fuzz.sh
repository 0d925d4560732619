# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2034,SC2154
#
# How tests/run fuzzes (tests/fuzz/README.md). Sourced after setup.sh, never run.

fuzz_dir=$root/build/fuzz # what it found and how far it got

# begin_fuzzing HARNESS DURATION: starts libFuzzer in the background.
begin_fuzzing() {
  local kept=$root/tests/fuzz/corpus/$1 words=$root/tests/fuzz/words/$1.dict options=()
  [[ -f $words ]] && options=(-dict="$words")
  mkdir -p "$fuzz_dir/inputs/$1" "$fuzz_dir/findings/$1"
  # The limits are libFuzzer's own: seconds and MB that one input may take.
  "$build_dir/tests/fuzz/clipscope_fuzz_$1" -max_total_time="$2" -timeout=20 -rss_limit_mb=2500 \
    -print_final_stats=1 "${options[@]}" -artifact_prefix="$fuzz_dir/findings/$1/" \
    "$fuzz_dir/inputs/$1" "$kept" >"$fuzz_dir/$1.log" 2>&1 &
}

# Inputs tried so far, by libFuzzer's log of a harness.
inputs_tried() {
  local tried
  tried=$(grep -Eo '^#[0-9]+|^Done [0-9]+' "$fuzz_dir/$1.log" | tail -n 1 | tr -dc 0-9) || true
  echo "${tried:-0}"
}

# end_fuzzing HARNESS STATUS: says what came of it; fails if something was found.
end_fuzzing() {
  local log=$fuzz_dir/$1.log input
  if [[ $2 -eq 0 ]]; then
    say "fuzz: $1: nothing found in $(inputs_tried "$1") inputs"
    return
  fi
  input=$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)
  grep -E -A 12 '^==[0-9]+==|what\(\):|runtime error' "$log" | head -n 40 >&2 || true
  say "fuzz: $1: FOUND something (log: $log). This replays it:
         ${build_dir#"$root"/}/tests/fuzz/clipscope_fuzz_$1 ${input:-(no input was written)}" >&2
  return 1
}

# Sets `pending` to the harnesses named, or to all.
choose_harnesses() {
  local harness
  pending=("$@")
  if [[ $# -eq 0 ]]; then
    for harness in "$root"/tests/fuzz/corpus/*/; do pending+=("$(basename "$harness")"); done
  fi
  for harness in "${pending[@]}"; do
    [[ -d $root/tests/fuzz/corpus/$harness ]] ||
      fail "--fuzz: there is no harness '$harness'; tests/fuzz/corpus has a folder for each"
  done
}

# Ends those of `running` whose process has ended; fails if one found something.
end_harnesses() {
  local pid status result=0
  for pid in "${!running[@]}"; do
    if kill -0 "$pid" 2>/dev/null; then continue; fi
    status=0
    wait "$pid" || status=$?
    end_fuzzing "${running[$pid]}" "$status" || result=1
    unset "running[$pid]"
  done
  return $result
}

# run_harnesses DURATION: all of `pending`, with a line for each that runs every 20 seconds.
run_harnesses() {
  local harness failed=0 shown=$SECONDS jobs
  local -A running=() # harness by process
  jobs=$(nproc)
  say "fuzz: ${pending[*]}: $1 s each, $jobs at a time"
  while [[ ${#pending[@]} -gt 0 || ${#running[@]} -gt 0 ]]; do
    while [[ ${#pending[@]} -gt 0 && ${#running[@]} -lt $jobs ]]; do
      begin_fuzzing "${pending[0]}" "$1"
      running[$!]=${pending[0]}
      pending=("${pending[@]:1}")
    done
    sleep 1
    end_harnesses || failed=1
    [[ $((SECONDS - shown)) -ge 20 ]] || continue
    shown=$SECONDS
    for harness in "${running[@]}"; do
      say "fuzz: $harness: $(inputs_tried "$harness") inputs so far"
    done
  done
  return $failed
}

# fuzz DURATION [HARNESS…]: builds the harnesses and gives each so many seconds, one on each core at a
# time; all of them if none is named. Fails at the end if any found something.
fuzz() {
  local duration=${1-} pending=()
  [[ $duration =~ ^[1-9][0-9]*$ ]] ||
    fail "--fuzz: '$duration' given, seconds per harness expected, such as 60"
  shift
  choose_harnesses "$@"
  preset=sanitize
  build_dir=$root/build/sanitize
  install_packages "${sanitize_packages[@]}"
  set_up clipscope_fuzz
  run_harnesses "$duration" || fail "fuzz: findings lie in ${fuzz_dir#"$root"/}/findings"
}
