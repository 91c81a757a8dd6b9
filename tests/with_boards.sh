#!/bin/sh
# with_boards.sh COMMAND...: runs a test on the boards that COPPERSCOPE_BOARDS names. Without them it ends with the code that ctest takes for
# "not run" (docs/testing.md).
if [ ! -d "${COPPERSCOPE_BOARDS:-}" ]; then
    echo "COPPERSCOPE_BOARDS names no folder of boards: not run"
    exit 77
fi
exec "$@"
