#!/usr/bin/env bash
# Installs what is missing, builds with assertions and runs every test.
#   tools/test.sh [--preset dev|asan|tsan|release] [ctest arguments]
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh

preset=dev
if [ "${1:-}" = --preset ]; then
  preset=$2
  shift 2
fi
spool_setup run test
spool_build "$preset"
# Where this machine must have GL and a virtual display, their absence is a failure and not a skip.
[ "${CI:-}" = true ] && export SPOOL_REQUIRE_GL=1
exec ctest --preset "$preset" -j "$(nproc)" "$@"
