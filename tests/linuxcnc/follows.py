"""Runs a program of LinuxCNC's as a file, and prints where it was whenever it moved: seconds, X, Y, Z, a line each."""

import sys
import time

import linuxcnc

state, told = linuxcnc.stat(), linuxcnc.command()


def does(command, *words):
    command(*words)
    told.wait_complete(2.0)


def ready():
    does(told.state, linuxcnc.STATE_ESTOP_RESET)
    does(told.state, linuxcnc.STATE_ON)
    does(told.mode, linuxcnc.MODE_MANUAL)
    state.poll()
    if not all(state.homed[: state.joints]):
        does(told.teleop_enable, 0)
        told.home(-1)
        while not all(state.homed[: state.joints]):
            time.sleep(0.05)
            state.poll()
    does(told.mode, linuxcnc.MODE_AUTO)


def follow(file):
    told.program_open(file)
    told.auto(linuxcnc.AUTO_RUN, 0)
    seen, begin, was = [], time.monotonic(), None
    while True:
        time.sleep(0.001)
        state.poll()
        now, at = time.monotonic() - begin, state.position[:3]
        if at != was:
            seen.append((now, *at))
            was = at
        if now > 0.5 and state.interp_state == linuxcnc.INTERP_IDLE and state.inpos and state.queue == 0:
            return seen


ready()
for row in follow(sys.argv[1]):
    print(*row)
