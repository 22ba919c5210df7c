#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job on the sample spool: in a window where there is a
# display, else headless into out/. Arguments, if any, go to spoolsight in place of the sample's.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh

spool_setup run
spool_build release spoolsight spoolsight-inspect

sample=(--design assets/sample/spool.glb --source assets/sample/recording)
if [ $# -gt 0 ]; then
  exec build/release/bin/spoolsight "$@"
elif [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec build/release/bin/spoolsight "${sample[@]}" --out out
fi
echo "No display: the sample job runs headless with a script of three taps."
build/release/bin/spoolsight "${sample[@]}" --headless --script assets/sample/taps.json \
  --track out/poses.csv --out out
echo "Written to out/:"
ls -1 out
