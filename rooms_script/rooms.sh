#!/bin/bash
# Namespaces follow rooms; server/exercise has inner rooms. Run it at the root of a worktree; it may be run again.
set -e
here=$(cd "$(dirname "$0")" && pwd)
cd "$(git rev-parse --show-toplevel)"
python3 "$here/rooms.py" "$PWD"
