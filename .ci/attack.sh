# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154
#
# How tests/run attacks the correctly rounded clipper at length (tests/spaces/attack/README.md). Sourced
# after setup.sh, never run.

# attack SECONDS [KIND…]: gives each kind of input so many seconds, one on each core at a time; all of
# them if none is named. Fails at the end if a bit was wrong.
attack() {
  local seconds=${1-} seed=$RANDOM$RANDOM program=$build_dir/tests/spaces/attack/clipscope_attack
  local all kind jobs kinds=()
  [[ $seconds =~ ^[1-9][0-9]*$ ]] ||
    fail "--attack: '$seconds' given, seconds for each kind of input expected, such as 60"
  shift
  set_up clipscope_attack
  mapfile -t all < <("$program" --list | awk '{ print $1 }')
  for kind in "$@"; do
    [[ " ${all[*]} " == *" $kind "* ]] ||
      fail "--attack: there is no kind '$kind'; there are ${all[*]}"
  done
  if [[ $# -gt 0 ]]; then kinds=("$@"); else kinds=("${all[@]}"); fi
  jobs=$(nproc)
  say "attack: ${#kinds[@]} kinds of input, $seconds s each, $jobs at a time, seed $seed"
  printf '%s\n' "${kinds[@]}" |
    xargs -P "$jobs" -I{} "$program" --seconds "$seconds" --seed "$seed" --kind {} ||
    fail "attack: FOUND a wrong bit, or a kind that did not reach what it is there for (above)"
  say "attack: no wrong bit"
}
