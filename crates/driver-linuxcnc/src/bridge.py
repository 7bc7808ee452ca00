#!/usr/bin/env python3
"""Kerf's bridge to LinuxCNC: carries pieces of path to it as program files, and tells its state.

It runs beside LinuxCNC and uses its public Python module. Kerf starts it as a child and speaks over its standard
input and output; `--listen PORT` has it serve one Kerf at a time over TCP instead.

A line is `TEXT*CRC`, the CRC-32 of the text in 8 hexadecimal digits. Lines from Kerf begin with their number, which
counts up from 0 (`hi`). One that is garbled or missing stops the machine: nobody knows what it said.

  hi N                        who are you: answered with `facts`; lines count from here
  keep                        Kerf is there
  piece N, g TICKET CODE, run a piece of path with its orders, and its start
  home, unlock                make piece N of nothing but that
  hold, resume, stop          as on the operator's panel; a stop switches outputs off
  feed, rapid, turn PERCENT   overrides
  zero CODE                   a change of a zero point

When Kerf is silent for 1.5 s what moves is held, after 12 s stopped; when its line ends, at once.
"""

import contextlib
import os
import select
import shutil
import signal
import socket
import sys
import tempfile
import time
import urllib.parse
import zlib

try:
    import linuxcnc
except ImportError:
    linuxcnc = None

VERSION = 2
TOLERANCE_MM = 0.01
SAME_LINE_MM = 0.002
MODES = f"G17 G21 G40 G80 G90 G91.1 G94 G97 G64 P{TOLERANCE_MM} Q{SAME_LINE_MM}"
LETTERS = "XYZABC"
SILENT_S, GONE_S = 1.5, 12.0
TICK_S, TELL_S, IDLE_S = 0.01, 0.02, 0.1
HOMING_S, FOREIGN_S = 280.0, 0.5
# What it was told shows in its state after this.
SETTLE_S = 0.03
# Its process is looked at so often.
ALIVE_S = 0.3
FIRST_OUTPUT, FIRST_INPUT = 4, 2
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
# Its file of parameters has the numbers of a system from here on, X first, its angle behind them.
FIRST_PARAMETER, PARAMETERS, ANGLE = 5221, 20, 9
# Zero points are looked at so often.
ZEROS_S = 0.2


class Ended(Exception):
    """The line has come to its end."""


class Pipe:
    """Standard input and output."""

    def __init__(self):
        self.reads, self.writes = os.dup(0), os.dup(1)
        # Whatever else prints must not come between two lines.
        os.dup2(2, 1)

    def read(self, wait_s):
        if not select.select([self.reads], [], [], wait_s)[0]:
            return b""
        try:
            got = os.read(self.reads, 1 << 16)
        except OSError as error:
            raise Ended from error
        if not got:
            raise Ended
        return got

    def write(self, data):
        try:
            while data:
                data = data[os.write(self.writes, data):]
        except OSError as error:
            raise Ended from error


class Net:
    """One connection over TCP."""

    def __init__(self, connection):
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.settimeout(1.0)
        self.connection = connection

    def read(self, wait_s):
        if not select.select([self.connection], [], [], wait_s)[0]:
            return b""
        try:
            got = self.connection.recv(1 << 16)
        except OSError as error:
            raise Ended from error
        if not got:
            raise Ended
        return got

    def write(self, data):
        try:
            self.connection.sendall(data)
        except OSError as error:
            raise Ended from error


@contextlib.contextmanager
def quiet():
    """Drops what the module of LinuxCNC itself writes to standard error: where no engine runs, Kerf says so."""
    kept, nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)


class Machine:
    """LinuxCNC: its state, and what it is told."""

    def __init__(self):
        with quiet():
            self.told, self.state = linuxcnc.command(), linuxcnc.stat()
            self.errors = linuxcnc.error_channel()
            self.state.poll()
        self.ini = linuxcnc.ini(self.state.ini_filename)
        mask = self.state.axis_mask
        self.axes = next((n for n in range(6) if not mask >> n & 1), 6)
        self.unit_mm = 1.0 / self.state.linear_units if self.state.linear_units else 1.0
        self.folder = tempfile.mkdtemp(prefix="kerf-")
        os.chmod(self.folder, 0o755)
        self.pins = self.digital()
        self.looked_s, self.alive = 0.0, True
        folder = os.path.dirname(self.state.ini_filename)
        self.parameters = os.path.join(folder, self.ini.find("RS274NGC", "PARAMETER_FILE") or "")
        self.saved, self.saved_at = {}, None

    def task(self):
        """The process that plans, by its number in /proc; nothing where it is not found."""
        name = os.path.basename(self.ini.find("TASK", "TASK") or "milltask")[:15]
        for number in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{number}/stat", encoding="utf-8") as file:
                    words = file.read()
            except OSError:
                continue
            if f"({name})" in words and words.rpartition(")")[2].split()[0] != "Z":
                return number
        return None

    def is_alive(self):
        """Its state stays as it was told last when its task is gone, so the process is looked at."""
        now_s = time.monotonic()
        if now_s - self.looked_s > ALIVE_S:
            self.looked_s, self.alive = now_s, self.task() is not None
        return self.alive

    def digital(self):
        """Bits of the outputs and inputs that its HAL has."""
        outputs = inputs = 0
        try:
            import hal
            component = hal.component(f"kerf-{os.getpid()}")
            component.ready()
            names = {pin["NAME"] for pin in hal.get_info_pins()}
            component.exit()
        except Exception:
            return outputs, inputs
        for number in range(32 - FIRST_OUTPUT):
            outputs |= (f"motion.digital-out-{number:02d}" in names) << (FIRST_OUTPUT + number - 1)
            inputs |= (f"motion.digital-in-{number:02d}" in names) << (FIRST_INPUT + number - 1)
        return outputs, inputs

    def scale(self, axis):
        return self.unit_mm if axis < 3 else 1.0

    def place(self, of):
        return ",".join(f"{of[axis] * self.scale(axis):.5f}" for axis in range(self.axes))

    def number(self, section, *keys):
        for key in keys:
            try:
                return float(self.ini.find(section, key).split()[0])
            except (AttributeError, ValueError, IndexError):
                pass
        return None

    def facts(self):
        joined = lambda values: ",".join("?" if value is None else f"{value:.6g}" for value in values)
        speeds, accels, ends = [], [], []
        for axis in range(self.axes):
            scale, section = self.scale(axis), f"AXIS_{LETTERS[axis]}"
            of = lambda key: (lambda value: None if value is None else value * scale)(self.number(section, key))
            speeds.append(of("MAX_VELOCITY"))
            accels.append(of("MAX_ACCELERATION"))
            limits = self.state.axis[axis]
            ends += [limits["min_position_limit"] * scale, limits["max_position_limit"] * scale]
        name = f"LinuxCNC {linuxcnc.version} ({self.ini.find('EMC', 'MACHINE') or 'no name'})"
        rpm = self.number("SPINDLE_0", "MAX_FORWARD_VELOCITY") or self.number("DISPLAY", "MAX_SPINDLE_0_SPEED")
        words = {
            "version": VERSION, "name": urllib.parse.quote(name), "axes": self.axes, "speed": joined(speeds),
            "accel": joined(accels), "travel": joined(ends), "outputs": self.pins[0] | 7,
            "inputs": self.pins[1] | 1, "rpm": f"{rpm or 10000.0:.6g}", "unfit": self.unfit(),
        }
        return "facts " + " ".join(f"{key}={value}" for key, value in words.items())

    def unfit(self):
        if self.axes < 3:
            return "axes"
        if self.state.kinematics_type != linuxcnc.KINEMATICS_IDENTITY:
            return "kinematics"
        return "no"

    def outputs(self):
        state, bits = self.state, 0
        bits |= 1 if state.spindle[0]["enabled"] else 0
        bits |= (2 if state.flood else 0) | (4 if state.mist else 0)
        for number in range(32 - FIRST_OUTPUT):
            bits |= (1 if state.dout[number] else 0) << (FIRST_OUTPUT + number - 1)
        return bits & (self.pins[0] | 7)

    def inputs(self):
        state, bits = self.state, 1 if self.state.probe_val else 0
        for number in range(32 - FIRST_OUTPUT):
            bits |= (1 if state.din[number] else 0) << (FIRST_INPUT + number - 1)
        return bits & (self.pins[1] | 1)

    def reads_parameters(self):
        """Reads its file of parameters anew where that has changed; one that cannot be read stays as it was."""
        try:
            saved_at = os.stat(self.parameters).st_mtime_ns
            if saved_at == self.saved_at:
                return
            with open(self.parameters, encoding="ascii") as file:
                pairs = [line.split() for line in file]
            self.saved = {int(pair[0]): float(pair[1]) for pair in pairs if len(pair) == 2}
            self.saved_at = saved_at
        except (OSError, ValueError):
            pass

    def saves_parameters(self):
        """Its file of parameters is one command behind, unless its interpreter is told to follow its motion.

        It is not told so in mode AUTO, which it has gone to by way of saving them. What it was told since it was looked at
        last may have led it out of that mode."""
        self.state.poll()
        if self.state.task_mode == linuxcnc.MODE_AUTO:
            return
        self.told.task_plan_synch()
        self.told.wait_complete(1.0)
        self.state.poll()

    def zeros(self):
        """Its zero points: the one that holds as its state tells it, the others as it has kept them."""
        self.reads_parameters()
        state, words, turned = self.state, {}, []
        holds = max(state.g5x_index, 1) - 1
        for index, name in enumerate(SYSTEMS):
            first = FIRST_PARAMETER + PARAMETERS * index
            at = [self.saved.get(first + axis) for axis in range(self.axes)]
            angle = self.saved.get(first + ANGLE, 0.0)
            if index == holds:
                at, angle = state.g5x_offset, state.rotation_xy
            if None not in at:
                words[name] = self.place(at)
            if angle != 0.0:
                turned.append(name)
        words["G92"], words["TLO"] = self.place(state.g92_offset), self.place(state.tool_offset)
        return {"holds": SYSTEMS[holds], **words, "turned": ",".join(turned)}

    def is_on(self):
        return self.state.task_state == linuxcnc.STATE_ON

    def is_homed(self):
        return all(self.state.homed[joint] for joint in range(self.state.joints))

    def stands(self):
        state = self.state
        return state.current_vel == 0 and (state.inpos or state.paused)

    def rests(self):
        """It has nothing left to do."""
        state = self.state
        return (state.state != linuxcnc.RCS_EXEC and state.queue == 0
                and state.interp_state == linuxcnc.INTERP_IDLE and state.inpos)

    def comes_to_rest(self):
        """Waits a moment until it has nothing left to do; tells whether it has not."""
        until_s = time.monotonic() + FOREIGN_S
        while not self.rests() and time.monotonic() < until_s:
            time.sleep(TICK_S / 2)
            self.state.poll()
        return self.rests()

    def mode(self, mode):
        self.state.poll()
        if self.state.task_mode != mode:
            self.told.mode(mode)
            self.told.wait_complete(2.0)

    def mdi(self, line):
        self.mode(linuxcnc.MODE_MDI)
        self.told.mdi(line)
        self.told.wait_complete(2.0)

    def open_and_run(self, lines):
        path = os.path.join(self.folder, "piece.ngc")
        with open(path, "w", encoding="ascii") as file:
            file.write("\n".join(["%", MODES, *lines, "%", ""]))
        self.mode(linuxcnc.MODE_AUTO)
        self.told.program_open(path)
        self.told.auto(linuxcnc.AUTO_RUN, 0)

    def switch_off(self):
        on = self.outputs()
        if on & 1:
            self.told.spindle(linuxcnc.SPINDLE_OFF)
        if on & 2:
            self.told.flood(linuxcnc.FLOOD_OFF)
        if on & 4:
            self.told.mist(linuxcnc.MIST_OFF)
        if self.is_on():
            for line in range(FIRST_OUTPUT, 33):
                if on >> (line - 1) & 1:
                    self.mdi(f"M65 P{line - FIRST_OUTPUT}")

    def says(self):
        """Words of an error that it told, or nothing."""
        told = self.errors.poll()
        if told and told[0] in (linuxcnc.NML_ERROR, linuxcnc.OPERATOR_ERROR):
            return " ".join(str(told[1]).split())
        return None


# Lines of a piece before the first order: the percent sign and the modes.
HEAD_LINES = 2


class Bridge:
    """One Kerf at the other end of a line."""

    def __init__(self, machine, line):
        self.machine, self.line = machine, line
        self.heard, self.next = b"", None
        self.piece, self.tickets, self.codes = 0, [], []
        self.doing, self.began_s = "idle", 0.0
        self.done, self.seen = 0, (0, 0)
        self.is_over, self.is_probe, self.contact = True, False, None
        self.held_for, self.hears_s, self.tells_s, self.last = None, time.monotonic(), 0.0, None
        self.why, self.says_facts, self.greeting = "", False, 0
        self.rested_s = time.monotonic()
        self.zeros_s = 0.0

    def serve(self):
        try:
            while True:
                self.heard += self.line.read(TICK_S)
                *lines, self.heard = self.heard.split(b"\n")
                for line in lines:
                    self.hear(line)
                self.machine.state.poll()
                if self.machine.is_alive():
                    self.follow()
                else:
                    self.fail("LinuxCNC is gone: what it had begun may go on, press the emergency stop")
                self.tell()
        except Ended:
            pass
        finally:
            self.leave()

    def leave(self):
        machine = self.machine
        machine.state.poll()
        if machine.is_alive() and (self.doing != "idle" or machine.outputs()):
            self.stop()
            until_s = time.monotonic() + 5.0
            while self.doing == "stopping" and time.monotonic() < until_s:
                time.sleep(TICK_S)
                machine.state.poll()
                self.follow()

    def hear(self, line):
        text, _, check = line.rpartition(b"*")
        self.hears_s = time.monotonic()
        try:
            right = int(check, 16) == zlib.crc32(text)
            number, command, *rest = text.decode("ascii").split(" ", 3)
            number = int(number)
        except ValueError:
            right = False
        if right and command == "hi":
            self.next, self.says_facts, self.why = 1, True, ""
            self.greeting, self.piece, self.done, self.is_over = int(rest[0]), 0, 0, True
            if self.doing == "stopped":
                self.doing, self.is_over = "idle", True
            self.zeros_s = 0.0
            if self.machine.is_on() and self.machine.rests():
                self.machine.saves_parameters()
            return
        if self.next is None:
            return
        if not right or number != self.next:
            self.next = None
            self.fail("a line was garbled on its way")
            self.stop()
            return
        self.next = number + 1
        if not self.machine.is_alive():
            return
        if self.held_for == "silence" and command != "stop":
            self.go_on()
        self.obey(command, rest)

    def obey(self, command, rest):
        told = self.machine.told
        if command == "g":
            self.tickets.append(int(rest[0]))
            self.codes.append(rest[1])
        elif command == "piece":
            self.piece, self.tickets, self.codes = int(rest[0]), [], []
        elif command in ("run", "home", "unlock"):
            self.begin(command)
        elif command == "hold":
            self.hold("order")
        elif command == "resume":
            self.go_on()
        elif command == "stop":
            self.stop()
        elif command == "feed":
            told.feedrate(int(rest[0]) / 100.0)
        elif command == "rapid":
            told.rapidrate(int(rest[0]) / 100.0)
        elif command == "turn":
            told.spindleoverride(int(rest[0]) / 100.0)
        elif command == "zero":
            self.change_zero(rest[0])

    def fail(self, why):
        self.why = self.why or why

    def begin(self, command):
        machine = self.machine
        machine.state.poll()
        while machine.says():
            pass
        self.began_s, self.is_over, self.seen, self.done = time.monotonic(), False, (0, 0), 0
        self.contact, self.why = None, ""
        if command == "unlock":
            machine.told.state(linuxcnc.STATE_ESTOP_RESET)
            machine.told.wait_complete(1.0)
            machine.told.state(linuxcnc.STATE_ON)
            machine.told.wait_complete(1.0)
            self.doing = "unlocking"
        elif not machine.is_on():
            self.fail("it is switched off: switch it on at its panel, or unlock it first (--unlock)")
        elif not machine.comes_to_rest():
            self.fail("somebody else has it at work")
        elif command == "home":
            machine.mode(linuxcnc.MODE_MANUAL)
            machine.told.teleop_enable(0)
            machine.told.wait_complete(1.0)
            machine.told.home(-1)
            self.doing = "homing"
        else:
            self.is_probe = any("G38" in code for code in self.codes)
            machine.open_and_run(self.codes)
            self.doing, self.began_s = "run", time.monotonic()

    def change_zero(self, code):
        machine = self.machine
        self.zeros_s = 0.0
        while machine.says():
            pass
        if self.doing != "idle" or not machine.comes_to_rest():
            self.fail("somebody else has it at work")
            return
        machine.mdi(f"G21 {code}")
        machine.saves_parameters()
        self.hears_error()

    def hold(self, cause):
        self.held_for = self.held_for or cause
        if self.doing == "run":
            self.machine.told.auto(linuxcnc.AUTO_PAUSE)

    def go_on(self):
        self.held_for = None
        if self.doing == "run" and self.machine.state.paused:
            self.machine.told.auto(linuxcnc.AUTO_RESUME)

    def stop(self):
        self.machine.told.abort()
        self.doing, self.held_for, self.began_s = "stopping", None, time.monotonic()
        self.tickets, self.codes = [], []

    def follow(self):
        self.look_for_silence()
        machine = self.machine
        if self.doing != "idle" or machine.rests():
            self.rested_s = time.monotonic()
        if self.doing == "run":
            self.follow_run()
        elif self.doing == "homing":
            if machine.is_homed() and machine.rests():
                self.ends()
            else:
                self.hears_error()
                if not machine.is_on() or time.monotonic() - self.began_s > HOMING_S:
                    self.fail("it did not get home")
        elif self.doing == "unlocking":
            if machine.is_on():
                self.ends()
            elif time.monotonic() - self.began_s > 2.0:
                self.fail("it cannot be switched on: its emergency stop is pressed")
        elif self.doing == "stopping" and time.monotonic() - self.began_s > SETTLE_S and machine.stands():
            machine.switch_off()
            self.doing = "stopped"

    def follow_run(self):
        machine, state = self.machine, self.machine.state
        if not machine.is_on():
            pressed = state.task_state == linuxcnc.STATE_ESTOP
            self.fail("its emergency stop was pressed" if pressed else "it was switched off")
            return
        self.hears_error()
        if state.queue and state.motion_line > HEAD_LINES and state.motion_line != self.seen[1]:
            # Lines that are made as one have the number of the last one: those before that one are made, no others.
            self.seen = (self.seen[1], state.motion_line)
            self.comes_to(self.seen[0])
        if time.monotonic() - self.began_s > SETTLE_S and machine.rests():
            if self.is_probe and state.probe_tripped:
                self.contact = machine.place(state.probed_position)
            self.ends()

    def comes_to(self, line):
        made = min(line - HEAD_LINES, len(self.tickets))
        # An order of several lines is made with its last one.
        if made > 0 and (made == len(self.tickets) or self.tickets[made] != self.tickets[made - 1]):
            self.done = max(self.done, self.tickets[made - 1])

    def ends(self):
        self.doing, self.is_over = "idle", True
        if self.tickets and not self.why:
            self.done = self.tickets[-1]

    def hears_error(self):
        said = self.machine.says()
        if said:
            self.fail(said)

    def look_for_silence(self):
        silent_s = time.monotonic() - self.hears_s
        if self.doing in ("run", "homing") and silent_s > SILENT_S and self.held_for is None:
            self.hold("silence")
        active = self.doing in ("run", "homing") or self.machine.outputs()
        if active and self.doing != "stopping" and silent_s > GONE_S:
            self.fail("it did not hear from Kerf for 12 s")
            self.stop()

    def shows(self):
        """What it does, in a word."""
        machine, state = self.machine, self.machine.state
        if not machine.alive:
            return "gone"
        if self.doing in ("stopping", "stopped"):
            return self.doing
        if state.task_state == linuxcnc.STATE_ESTOP:
            return "estop"
        if not machine.is_on():
            return "off"
        if self.doing == "run" and state.paused:
            if state.current_vel != 0:
                return "slowing"
            return "held" if self.held_for else "panel"
        if self.held_for and self.doing == "idle":
            return "held"
        if self.doing == "idle" and time.monotonic() - self.rested_s > FOREIGN_S:
            return "foreign"
        return self.doing

    def tell(self):
        if self.says_facts:
            self.says_facts = False
            self.say(self.machine.facts())
        now_s, machine, state = time.monotonic(), self.machine, self.machine.state
        if self.next is None and not self.why:
            return
        each_s = IDLE_S if self.doing == "idle" else TELL_S
        words = {
            "hi": self.greeting, "next": self.next or 0, "piece": self.piece, "done": self.done, "over": int(self.is_over),
            "doing": self.shows(), "homed": int(machine.is_homed()), "moves": int(not machine.stands()),
            "at": machine.place(state.actual_position), "out": machine.outputs(), "in": machine.inputs(),
            "feed": round(state.feedrate * 100), "rapid": round(state.rapidrate * 100),
            "turn": round(state.spindle[0]["override"] * 100),
        }
        if self.contact:
            words["contact"] = self.contact
        if self.why:
            words["why"] = urllib.parse.quote(self.why)
        text = "s " + " ".join(f"{key}={value}" for key, value in words.items())
        if text == self.last and now_s - self.tells_s < IDLE_S or now_s - self.tells_s < TELL_S:
            return
        # Whoever hears a state first knows the zero points by then.
        if self.next is not None and now_s - self.zeros_s > ZEROS_S:
            self.tell_zeros(now_s)
        self.last, self.tells_s = text, now_s
        self.say(text)

    def tell_zeros(self, now_s):
        self.zeros_s = now_s
        words = {"hi": self.greeting, "next": self.next, **self.machine.zeros()}
        self.say("z " + " ".join(f"{key}={value}" for key, value in words.items()))

    def say(self, text):
        data = text.encode("ascii")
        self.line.write(data + b"*%08x\n" % zlib.crc32(data))


def serve_net(machine, host, port):
    server = socket.create_server((host, port))
    print(f"Kerf's bridge to LinuxCNC listens at {host}:{port}", file=sys.stderr)
    while True:
        connection, _ = server.accept()
        with connection:
            Bridge(machine, Net(connection)).serve()


def cannot(why):
    """Says in place of facts why there are none."""
    data = f"facts version={VERSION} unfit={why}".encode("ascii")
    Pipe().write(data + b"*%08x\n" % zlib.crc32(data))
    sys.exit(1)


def main(arguments):
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    if linuxcnc is None:
        return cannot("module")
    try:
        machine = Machine()
    except linuxcnc.error:
        return cannot("absent")
    try:
        if arguments[:1] == ["--listen"]:
            host, _, port = ("127.0.0.1:" + arguments[1]).rpartition(":")
            serve_net(machine, host.rpartition(":")[2] or host, int(port))
        else:
            # Ctrl-C and a terminal that closes are Kerf's to hear: it stops, lifts, and ends the line.
            for heard in (signal.SIGINT, signal.SIGHUP):
                signal.signal(heard, signal.SIG_IGN)
            Bridge(machine, Pipe()).serve()
    finally:
        shutil.rmtree(machine.folder, ignore_errors=True)


if __name__ == "__main__":
    main(sys.argv[1:])
