//! Traces of signals as Value Change Dump (IEEE 1364), which GTKWave and other viewers read.
//!
//! Changes may be told a little out of order: they are kept until [`Vcd::flush`] says that nothing
//! earlier can come. Times are nanoseconds.

use std::collections::BTreeMap;
use std::fmt::Write;

/// The kinds of signals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One bit.
    Wire,
    /// A byte, bit by bit.
    Byte,
    /// A whole number.
    Integer,
    /// Any number.
    Real,
}

/// Which signal, in the order in which they were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Id(usize);

struct Signal {
    scope: &'static str,
    name: String,
    kind: Kind,
    value: f64,
    /// The byte of which it is a bit, and which.
    part_of: Option<(usize, u8)>,
}

/// A trace being written.
#[derive(Default)]
pub struct Vcd {
    signals: Vec<Signal>,
    /// Time, signal and value, in the order in which they were told.
    pending: Vec<(u64, usize, f64)>,
    /// The time written last.
    written_ns: Option<u64>,
    /// Bytes whose bits have changed at the time at hand, and what they read now.
    bytes: BTreeMap<usize, u8>,
}

/// Nanoseconds in a second.
const NS: f64 = 1e9;

impl Vcd {
    /// Adds a signal that reads 0 until it changes. Signals of one scope are added one after the
    /// other.
    pub fn signal(&mut self, scope: &'static str, name: impl Into<String>, kind: Kind) -> Id {
        let name = name.into();
        self.signals.push(Signal { scope, name, kind, value: 0.0, part_of: None });
        Id(self.signals.len() - 1)
    }

    /// Adds a byte that is made of wires, bit 0 first: it changes with them, and once where several of them
    /// change at a time.
    pub fn byte_of(&mut self, scope: &'static str, name: impl Into<String>, wires: &[Id]) {
        let byte = self.signal(scope, name, Kind::Byte);
        for (place, wire) in wires.iter().enumerate() {
            self.signals[wire.0].part_of = Some((byte.0, 1 << place));
        }
    }

    /// The head of the file, with the values at time 0.
    pub fn header(&mut self) -> String {
        let mut out = String::from("$version kerf $end\n$timescale 1 ns $end\n");
        let mut scope = "";
        for (i, signal) in self.signals.iter().enumerate() {
            if signal.scope != scope {
                let end = if scope.is_empty() { "" } else { "$upscope $end\n" };
                let _ = writeln!(out, "{end}$scope module {} $end", signal.scope);
                scope = signal.scope;
            }
            let (word, bits) = signal.kind.declared();
            let _ = writeln!(out, "$var {word} {bits} {} {} $end", code(i), signal.name);
        }
        out.push_str("$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n");
        for (i, signal) in self.signals.iter().enumerate() {
            signal.write(signal.value, i, &mut out);
        }
        out.push_str("$end\n");
        self.written_ns = Some(0);
        out
    }

    /// A signal changes at a time in seconds.
    pub fn at(&mut self, t_s: f64, id: Id, value: f64) {
        self.at_ns((t_s * NS).round().max(0.0) as u64, id, value);
    }

    /// A signal changes at a time in nanoseconds.
    pub fn at_ns(&mut self, t_ns: u64, id: Id, value: f64) {
        self.pending.push((t_ns, id.0, value));
    }

    /// The lines of every change before a time in seconds; what is told at one time stays in order.
    pub fn flush(&mut self, before_s: f64) -> String {
        self.pending.sort_by_key(|(t_ns, ..)| *t_ns);
        let split = self.pending.partition_point(|(t_ns, ..)| (*t_ns as f64) < before_s * NS);
        let rest = self.pending.split_off(split);
        let due = std::mem::replace(&mut self.pending, rest);
        let mut out = String::new();
        let mut now_ns = None;
        for (t_ns, i, value) in due {
            if now_ns.replace(t_ns) != Some(t_ns) {
                self.write_bytes(&mut out);
            }
            self.change(t_ns, i, value, &mut out);
        }
        self.write_bytes(&mut out);
        out
    }

    /// Everything at one time is told: the bytes follow their bits.
    fn write_bytes(&mut self, out: &mut String) {
        for (i, value) in std::mem::take(&mut self.bytes) {
            let value = f64::from(value);
            if std::mem::replace(&mut self.signals[i].value, value) != value {
                self.signals[i].write(value, i, out);
            }
        }
    }

    fn change(&mut self, t_ns: u64, i: usize, value: f64, out: &mut String) {
        if std::mem::replace(&mut self.signals[i].value, value) == value {
            return;
        }
        // Told too late: it is shown as soon as it can be.
        let t_ns = t_ns.max(self.written_ns.unwrap_or(0));
        if self.written_ns.replace(t_ns) != Some(t_ns) {
            let _ = writeln!(out, "#{t_ns}");
        }
        self.signals[i].write(value, i, out);
        if let Some((byte, mask)) = self.signals[i].part_of {
            let before = self.signals[byte].value as u8;
            let now = self.bytes.entry(byte).or_insert(before);
            *now = if value == 0.0 { *now & !mask } else { *now | mask };
        }
    }
}

impl Kind {
    const fn declared(self) -> (&'static str, u8) {
        match self {
            Self::Wire => ("wire", 1),
            Self::Byte => ("wire", 8),
            Self::Integer => ("integer", 32),
            Self::Real => ("real", 64),
        }
    }
}

impl Signal {
    fn write(&self, value: f64, i: usize, out: &mut String) {
        let code = code(i);
        let _ = match self.kind {
            Kind::Wire => writeln!(out, "{}{code}", u8::from(value != 0.0)),
            Kind::Byte => writeln!(out, "b{:08b} {code}", value as u8),
            Kind::Integer => writeln!(out, "b{:b} {code}", value as i64 as i32),
            Kind::Real => writeln!(out, "r{value} {code}"),
        };
    }
}

/// The short name of a signal: printable characters from `!`.
fn code(mut i: usize) -> String {
    const FIRST: u8 = b'!';
    const LETTERS: usize = 94;
    let mut out = String::new();
    loop {
        out.push(char::from(FIRST + (i % LETTERS) as u8));
        i /= LETTERS;
        if i == 0 {
            return out;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_written_in_order_and_only_when_they_change() {
        let mut vcd = Vcd::default();
        let bit = vcd.signal("out", "tool1", Kind::Wire);
        let byte = vcd.signal("out", "b", Kind::Byte);
        let place = vcd.signal("axes", "x", Kind::Integer);
        let head = vcd.header();
        assert!(
            head.contains(
                "$scope module out $end\n$var wire 1 ! tool1 $end\n$var wire 8 \" b $end"
            )
        );
        assert!(head.contains("$upscope $end\n$scope module axes $end\n$var integer 32 # x $end"));
        assert!(head.ends_with("#0\n$dumpvars\n0!\nb00000000 \"\nb0 #\n$end\n"));
        vcd.at(2e-6, bit, 1.0);
        vcd.at(1e-6, place, -1.0);
        vcd.at(1e-6, byte, 4.0);
        vcd.at(3e-6, bit, 1.0);
        vcd.at(4e-6, bit, 0.0);
        let all = format!("b{} #", "1".repeat(32));
        assert_eq!(vcd.flush(3.5e-6), format!("#1000\n{all}\nb00000100 \"\n#2000\n1!\n"));
        assert_eq!(vcd.flush(f64::INFINITY), "#4000\n0!\n");
    }

    #[test]
    fn a_byte_follows_its_bits_once_a_time() {
        let mut vcd = Vcd::default();
        let bits = ["a", "b"].map(|name| vcd.signal("out", name, Kind::Wire));
        vcd.byte_of("out", "byte", &bits);
        vcd.header();
        vcd.at_ns(1, bits[0], 1.0);
        vcd.at_ns(2, bits[0], 0.0);
        vcd.at_ns(1, bits[1], 1.0);
        let told = "#1\n1!\n1\"\nb00000011 #\n#2\n0!\nb00000010 #\n";
        assert_eq!(vcd.flush(f64::INFINITY), told);
    }

    #[test]
    fn many_signals_have_names_of_their_own() {
        let codes: std::collections::BTreeSet<_> = (0..500).map(code).collect();
        assert_eq!(codes.len(), 500);
        assert!(codes.iter().all(|it| it.chars().all(|c| c.is_ascii_graphic())));
    }
}
