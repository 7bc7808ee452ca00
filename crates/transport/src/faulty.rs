//! A line that does damage to what passes, at bytes that are named before: from a seed the same faults come again.

use crate::{Line, LineError};
use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Damage to one byte, or to all from there on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damage {
    /// The byte does not arrive.
    Lost,
    /// It arrives twice.
    Doubled,
    /// It arrives with other bits.
    Flipped(u8),
    /// It and all behind it arrive so much later.
    Delayed(Duration),
    /// The line is gone: nothing passes any more.
    Cut,
}

/// One fault of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// It is of the way to the controller; else of the way back.
    pub there: bool,
    /// Bytes that pass on that way before it, counted from the fault before.
    pub after: u64,
    /// The damage.
    pub damage: Damage,
}

/// A line with faults.
#[derive(Debug)]
pub struct Faulty<L> {
    line: L,
    /// Faults of the way to the controller, and of the way back.
    faults: [VecDeque<Fault>; 2],
    /// Bytes that came, and have not passed yet.
    late: VecDeque<u8>,
    until: Option<Instant>,
    cut: bool,
}

impl<L> Faulty<L> {
    /// A line with faults that come one behind the other.
    pub fn new(line: L, faults: &[Fault]) -> Self {
        let of = |there| faults.iter().copied().filter(|fault| fault.there == there).collect();
        Self { line, faults: [of(true), of(false)], late: VecDeque::new(), until: None, cut: false }
    }

    /// Another fault comes, behind all others.
    pub fn comes(&mut self, fault: Fault) {
        self.faults[usize::from(!fault.there)].push_back(fault);
    }

    /// Returns bytes as they pass.
    fn pass(&mut self, there: bool, bytes: &[u8]) -> Vec<u8> {
        let mut passed = Vec::with_capacity(bytes.len());
        let faults = &mut self.faults[usize::from(!there)];
        for byte in bytes {
            let due = faults.front_mut().and_then(|fault| {
                let is_due = fault.after == 0;
                fault.after = fault.after.saturating_sub(1);
                is_due.then_some(fault.damage)
            });
            if due.is_some() {
                faults.pop_front();
            }
            match due {
                None => passed.push(*byte),
                Some(Damage::Lost) => {}
                Some(Damage::Doubled) => passed.extend([*byte, *byte]),
                Some(Damage::Flipped(bits)) => passed.push(byte ^ bits),
                Some(Damage::Delayed(by)) => {
                    passed.push(*byte);
                    self.until = Some(Instant::now() + by);
                }
                Some(Damage::Cut) => self.cut = true,
            }
            if self.cut {
                break;
            }
        }
        passed
    }

    fn is_there(&self) -> Result<(), LineError> {
        let gone = || LineError::Gone { path: "(faulty)".into(), why: "it was cut".into() };
        if self.cut { Err(gone()) } else { Ok(()) }
    }

    fn is_late(&self) -> bool {
        self.until.is_some_and(|until| Instant::now() < until)
    }
}

impl<L: Line> Line for Faulty<L> {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        self.is_there()?;
        // A byte that comes twice needs room for one more.
        let room = into.len() / 2;
        let count = self.line.read(&mut into[..room], wait)?;
        let came = self.pass(false, &into[..count]);
        self.late.extend(came);
        if self.is_late() {
            return Ok(0);
        }
        let count = into.len().min(self.late.len());
        self.late.drain(..count).zip(into).for_each(|(byte, to)| *to = byte);
        Ok(count)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        self.is_there()?;
        let passed = self.pass(true, bytes);
        if let Some(until) = self.until.take() {
            std::thread::sleep(until.saturating_duration_since(Instant::now()));
        }
        self.line.write(&passed)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A line that gives back what it is sent.
    #[derive(Default)]
    struct Echo(VecDeque<u8>);

    impl Line for Echo {
        fn read(&mut self, into: &mut [u8], _: Duration) -> Result<usize, LineError> {
            let count = into.len().min(self.0.len());
            self.0.drain(..count).zip(into).for_each(|(byte, to)| *to = byte);
            Ok(count)
        }

        fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
            self.0.extend(bytes);
            Ok(())
        }
    }

    /// Returns what comes back of the ten digits.
    fn back(faults: &[Fault]) -> Result<Vec<u8>, LineError> {
        let mut line = Faulty::new(Echo::default(), faults);
        line.write(b"0123456789")?;
        let mut bytes = [0; 64];
        let count = line.read(&mut bytes, Duration::ZERO)?;
        Ok(bytes[..count].to_vec())
    }

    #[test]
    fn faults_come_where_they_are_named() {
        let check = |faults: &[(bool, u64, Damage)], expected: &[u8]| {
            let fault = |&(there, after, damage)| Fault { there, after, damage };
            let faults: Vec<Fault> = faults.iter().map(fault).collect();
            assert_eq!(back(&faults).unwrap(), expected, "{faults:?}");
        };
        check(&[], b"0123456789");
        check(&[(true, 3, Damage::Lost)], b"012456789");
        check(&[(false, 0, Damage::Doubled)], b"00123456789");
        check(&[(true, 9, Damage::Flipped(1))], b"0123456788");
        check(&[(true, 1, Damage::Lost), (true, 1, Damage::Lost)], b"02456789");
        check(&[(true, 1, Damage::Lost), (false, 1, Damage::Lost)], b"03456789");
        check(&[(false, 4, Damage::Delayed(Duration::from_secs(60)))], b"");
    }

    #[test]
    fn a_cut_line_is_gone() {
        let cut = Fault { there: false, after: 4, damage: Damage::Cut };
        let mut line = Faulty::new(Echo::default(), &[cut]);
        line.write(b"0123456789").unwrap();
        let mut bytes = [0; 64];
        assert_eq!(line.read(&mut bytes, Duration::ZERO), Ok(4));
        assert!(line.read(&mut bytes, Duration::ZERO).is_err());
        assert!(line.write(b"?").is_err());
    }
}
