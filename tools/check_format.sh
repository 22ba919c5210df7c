#!/usr/bin/env bash
# Says which files clang-format 14 would change; exit 1 if any. `tools/check_format.sh --fix` changes them.
set -euo pipefail
cd "$(dirname "$0")/.."
format=${CLANG_FORMAT:-clang-format-14}
mapfile -t files < <(find vision render app tools tests -name '*.h' -o -name '*.cpp' | sort)
if [ "${1:-}" = --fix ]; then
  "$format" -i "${files[@]}"
else
  "$format" --dry-run -Werror "${files[@]}"
fi
