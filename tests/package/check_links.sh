#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every relative link and picture of the Markdown files names something that exists.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

cd "$root"
status=0
while IFS= read -r file; do
  while IFS= read -r target; do
    case $target in
      http*:* | mailto:* | \#* | '') continue ;;
    esac
    if [[ ! -e $(dirname -- "$file")/${target%%#*} ]]; then
      echo "$file links to $target, which does not exist" >&2
      status=1
    fi
  done < <(awk '$1 ~ /^```/ { code = !code } !code' "$file" | grep -oE '\]\([^)]+\)' | sed -E 's/^\]\(([^ )]*).*/\1/')
done < <(find . -name '*.md' -not -path './build/*' -not -path './results/*' -not -path './.git/*' \
  -not -path '*/node_modules/*')
exit $status
