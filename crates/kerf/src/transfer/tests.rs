//! Both ends on a line that spoils, loses and cuts.

use super::{Receiver, Sender, State};

/// A line with a clock.
#[derive(Default)]
struct Line {
    now_s: f64,
    /// Bytes from the sender so far.
    sent: usize,
    /// Those of them that are spoiled.
    spoiled: Vec<usize>,
    cut: bool,
    moving: bool,
}

impl Line {
    fn tick(&mut self, sender: &mut Sender, receiver: &mut Receiver) {
        self.now_s += 0.01;
        let mut out = sender.speak(self.now_s);
        for byte in &mut out {
            *byte ^= u8::from(self.spoiled.contains(&self.sent));
            self.sent += 1;
        }
        let over = |bytes: Vec<u8>| if self.cut { Vec::new() } else { bytes };
        receiver.hear(&over(out), self.moving, self.now_s);
        if receiver.file().is_some() && receiver.progress().done == receiver.progress().total {
            receiver.kept();
        }
        let back = over(receiver.speak());
        sender.hear(&back, self.now_s);
    }

    fn run(&mut self, sender: &mut Sender, receiver: &mut Receiver, seconds: f64) {
        let until_s = self.now_s + seconds;
        while self.now_s < until_s {
            self.tick(sender, receiver);
        }
    }
}

fn file() -> Vec<u8> {
    (0..5000_u32).map(|i| (i * i % 251) as u8).collect()
}

fn ends() -> (Line, Sender, Receiver) {
    let sender = Sender::new("SAMPLE.RSM", file(), 19_200).expect("a file");
    (Line::default(), sender, Receiver::default())
}

#[test]
fn a_file_arrives_as_it_is_although_bytes_are_spoiled() {
    let (mut line, mut sender, mut receiver) = ends();
    line.spoiled = vec![3, 40, 700, 2000, 2001, 4100];
    line.run(&mut sender, &mut receiver, 60.0);
    assert_eq!((sender.state(), receiver.state()), (&State::Done, &State::Done));
    assert_eq!(receiver.file(), Some(("SAMPLE.RSM", &*file())));
    assert!(line.sent > 5000 + 256, "damaged blocks came again: {} bytes", line.sent);
}

#[test]
fn nothing_is_taken_while_the_machine_moves() {
    let (mut line, mut sender, mut receiver) = ends();
    line.run(&mut sender, &mut receiver, 0.05);
    line.moving = true;
    line.run(&mut sender, &mut receiver, 0.5);
    let held = receiver.progress().done;
    line.run(&mut sender, &mut receiver, 30.0);
    assert_eq!(receiver.progress().done, held);
    assert_eq!((sender.state(), receiver.state()), (&State::Held, &State::Held));
    line.moving = false;
    line.run(&mut sender, &mut receiver, 10.0);
    assert_eq!(receiver.file(), Some(("SAMPLE.RSM", &*file())));
}

#[test]
fn either_end_stops_it() {
    for at_sender in [true, false] {
        let (mut line, mut sender, mut receiver) = ends();
        line.run(&mut sender, &mut receiver, 0.05);
        if at_sender {
            sender.stop()
        } else {
            receiver.stop()
        }
        line.run(&mut sender, &mut receiver, 0.1);
        assert_eq!((sender.state(), receiver.state()), (&State::Stopped, &State::Stopped));
        assert_eq!((receiver.file(), receiver.progress().done), (None, 0));
    }
}

#[test]
fn a_cut_line_is_told_within_ten_seconds() {
    let (mut line, mut sender, mut receiver) = ends();
    line.run(&mut sender, &mut receiver, 0.05);
    line.cut = true;
    line.run(&mut sender, &mut receiver, 10.0);
    assert!(matches!(sender.state(), State::Failed(_)), "{:?}", sender.state());
    assert!(matches!(receiver.state(), State::Failed(_)), "{:?}", receiver.state());
    assert_eq!(receiver.progress().done, 0);
}

#[test]
fn small_files_arrive_and_odd_names_do_not() {
    for length in [0, 1, 255, 256, 257, 512] {
        let bytes = vec![0x16; length];
        let mut sender = Sender::new("a.rsm", bytes.clone(), 2400).expect("a file");
        let (mut line, mut receiver) = (Line::default(), Receiver::default());
        line.run(&mut sender, &mut receiver, 5.0);
        assert_eq!(receiver.file(), Some(("a.rsm", &*bytes)), "{length}");
        assert_eq!(sender.state(), &State::Done, "{length}");
    }
    for name in ["../a.rsm", "", ".x", "a/b", "c:\\a"] {
        let mut sender = Sender::new(name, vec![1], 9600).expect("a file");
        let (mut line, mut receiver) = (Line::default(), Receiver::default());
        line.run(&mut sender, &mut receiver, 2.0);
        assert!(matches!(receiver.state(), State::Failed(_)), "{name}");
        assert!(matches!(sender.state(), State::Failed(_)), "{name}");
    }
}
