#!/usr/bin/env bash
# own_display.sh COMMAND...: runs it in a display of its own, with a window manager and software GL,
# so that windows behave as on a desk, keys go to the active window of no other test, and pictures do
# not depend on the machine's graphics card. The exit status is the command's.
set -euo pipefail

place=$(mktemp -d)
server=
manager=
leave() {
    [ -z "$manager" ] || kill "$manager" 2>/dev/null || true
    [ -z "$server" ] || { kill "$server" && wait "$server"; } 2>/dev/null || true
    rm -rf "$place"
}
trap leave EXIT
trap 'exit 143' TERM INT HUP

# The server itself takes a number that is free and tells it: two that begin together never share one.
mkfifo "$place/display" "$place/managed"
Xvfb -displayfd 3 -screen 0 1920x1080x24 -nolisten tcp -noreset 3>"$place/display" 2>"$place/errors" &
server=$!
if ! read -r -t 60 number <"$place/display"; then
    echo "own_display.sh: Xvfb did not start: $(cat "$place/errors")" >&2
    exit 1
fi
export DISPLAY=":$number" LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
unset XAUTHORITY WAYLAND_DISPLAY
# No message bus: Qt's thread would start one by a fork, in which the memory of a sanitizer may be locked
# for ever.
export DBUS_SESSION_BUS_ADDRESS=disabled:

openbox --startup "sh -c 'echo ready >$place/managed'" >/dev/null 2>&1 &
manager=$!
if ! read -r -t 60 _ <>"$place/managed"; then
    echo "own_display.sh: openbox did not start on display $DISPLAY" >&2
    exit 1
fi

"$@" &
command=$!
trap 'kill "$command" 2>/dev/null; exit 143' TERM INT HUP
wait "$command"
