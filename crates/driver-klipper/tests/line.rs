//! A host's line to a fake board: joined, identified, commands run once and in order.

use kerf_driver_klipper::dictionary::{Dictionary, Wanted};
use kerf_driver_klipper::fake::{Board, Faults, Line};
use kerf_driver_klipper::identify::Identify;
use kerf_driver_klipper::link::{Heard, Join, Link};

/// Grain of virtual time, seconds.
const GRAIN_S: f64 = 0.000_5;
const STEP: Wanted = Wanted { name: "queue_step", fields: &["oid", "interval", "count", "add"] };
const POSITION: Wanted = Wanted { name: "stepper_get_position", fields: &["oid"] };

struct Wires {
    board: Board,
    there: Line,
    back: Line,
    now_s: f64,
}

impl Wires {
    fn new(seed: u64, faults: Faults) -> Self {
        let line = |n| Line::new(seed * 2 + n, faults, 0.001);
        Self { board: Board::of_seed(seed), there: line(0), back: line(1), now_s: 0.0 }
    }

    /// Lets a grain of time go by; returns the bytes for the host.
    fn pass(&mut self, bytes: &[u8]) -> Vec<u8> {
        self.there.put(bytes, self.now_s);
        self.now_s += GRAIN_S;
        let come = self.there.take(self.now_s);
        let clock = self.board.clock_at(self.now_s);
        self.board.run_to(clock);
        self.board.feed(&come);
        let said = self.board.take();
        self.back.put(&said, self.now_s);
        self.back.take(self.now_s)
    }

    fn join(&mut self) -> Link {
        let mut join = Join::new(self.now_s);
        let mut bytes = Vec::new();
        for _ in 0..30_000 {
            if let Some(expected) = join.receive(&bytes, self.now_s) {
                return Link::new(expected);
            }
            assert!(!join.is_vain(self.now_s), "the board does not answer");
            let out = join.transmit(self.now_s);
            bytes = self.pass(&out);
        }
        panic!("not joined");
    }

    fn identify(&mut self, link: &mut Link) -> Dictionary {
        let mut identify = Identify::new(self.now_s);
        for _ in 0..200_000 {
            if let Some(question) = identify.ask(self.now_s) {
                assert!(link.send(question, None));
            }
            for heard in self.turn(link) {
                let Heard::Message(message) = heard else { continue };
                if let Some(dictionary) =
                    identify.heard(&message, self.now_s).expect("a dictionary")
                {
                    return dictionary;
                }
            }
        }
        panic!("not identified");
    }

    fn turn(&mut self, link: &mut Link) -> Vec<Heard> {
        let out = link.transmit(self.now_s);
        let bytes = self.pass(&out.bytes);
        link.receive(&bytes, self.now_s)
    }
}

fn check_order(seed: u64, faults: Faults, commands: u32) -> (Wires, Link) {
    let mut wires = Wires::new(seed, faults);
    let mut link = wires.join();
    let dictionary = wires.identify(&mut link);
    let out = Wanted { name: "set_digital_out", fields: &["pin", "value"] };
    let out = dictionary.command(&out).expect("a command");
    // Each command of a pin of its own shows that it ran; twice or late shows in the order of edges.
    for n in 0..commands {
        assert!(link.send(out.numbers([1000 + n, 1]).expect("numbers"), None));
    }
    while !link.is_idle() {
        wires.turn(&mut link);
        assert!(link.silent_s(wires.now_s) < 5.0, "seed {seed}: nothing comes through");
    }
    let pins: Vec<u32> = wires.board.edges.iter().map(|edge| edge.pin).collect();
    let expected: Vec<u32> = (1000..1000 + commands).collect();
    assert_eq!(pins, expected, "seed {seed}");
    assert_eq!(wires.board.ran["set_digital_out"], u64::from(commands), "seed {seed}");
    (wires, link)
}

#[test]
fn a_board_is_joined_and_tells_its_own_words() {
    for seed in 0..20 {
        let mut wires = Wires::new(seed, Faults::default());
        let mut link = wires.join();
        let dictionary = wires.identify(&mut link);
        assert_eq!(dictionary.version(), "fake-1");
        assert_eq!(dictionary.constant("CLOCK_FREQ"), Some(12e6));
        assert_eq!(dictionary.text("MCU"), Some("rp2040"));
        assert_eq!(dictionary.number("pin", "gpio17"), Ok(17));
        assert_eq!(dictionary.number("pin", "PA7"), Ok(71));
        assert!(dictionary.number("pin", "PA8").is_err());
        assert!(dictionary.command(&STEP).is_ok());
        assert!(dictionary.command(&Wanted { name: "queue_step", fields: &["oid"] }).is_err());
    }
}

/// Time in which a board behind a line with such a round trip is joined, and tells its words.
fn identified_s(trip_s: f64, faults: Faults) -> [f64; 2] {
    let mut wires = Wires::new(4, faults);
    (wires.there.delay_s, wires.back.delay_s) = (0.5 * trip_s, 0.5 * trip_s);
    let mut link = wires.join();
    let joined_s = wires.now_s;
    assert_eq!(wires.identify(&mut link).version(), "fake-1");
    [joined_s, wires.now_s - joined_s]
}

#[test]
fn the_words_of_a_board_behind_a_long_line_come_in_a_window() {
    // Piece after piece it is more than 40 round trips.
    let most_trips = 20.0;
    for trip_s in [0.04, 0.1, 0.3, 1.0] {
        let [_, took_s] = identified_s(trip_s, Faults::default());
        println!("round trip {trip_s} s: {took_s:.2} s");
        assert!(took_s < most_trips * trip_s, "{trip_s}: {took_s}");
        let [_, spoilt_s] = identified_s(trip_s, Faults::all(0.01));
        println!("round trip {trip_s} s, 1 % of frames spoiled: {spoilt_s:.2} s");
    }
}

#[test]
fn commands_run_once_and_in_order_on_a_clean_line() {
    let (wires, link) = check_order(1, Faults::default(), 2000);
    assert_eq!(link.troubles(), [0, 0], "nothing went out twice");
    assert!(wires.now_s < 2.0, "the line is kept full: {} s", wires.now_s);
}

#[test]
fn commands_run_once_and_in_order_on_a_faulty_line() {
    for seed in 0..30 {
        let (wires, _) = check_order(seed, Faults::all(0.01), 2000);
        assert!(wires.there.mistakes > 5, "seed {seed}: the line was faulty");
    }
    check_order(77, Faults::all(0.05), 500);
}

#[test]
fn a_half_frame_of_a_former_host_does_not_matter() {
    for half in 1..9 {
        let mut wires = Wires::new(3, Faults::default());
        let frame = [0x09, 0x10, 1, 0, 40, 1, 2, 3, 4];
        wires.board.feed(&frame[..half]);
        let mut link = wires.join();
        wires.identify(&mut link);
    }
}

#[test]
fn a_line_without_a_board_is_told() {
    let mut join = Join::new(0.0);
    let asked = (0..120).filter(|n| !join.transmit(f64::from(*n) * 0.1).is_empty()).count();
    assert!(asked > 40, "it goes on asking: {asked}");
    assert!(!join.is_vain(9.9) && join.is_vain(10.1));
}

#[test]
fn a_small_buffer_of_a_board_is_never_overrun() {
    let mut wires = Wires::new(5, Faults::all(0.01));
    let mut link = wires.join();
    let dictionary = wires.identify(&mut link);
    link.limit(192);
    let ask = dictionary.command(&POSITION).expect("a command").numbers([7]).expect("numbers");
    let nop = dictionary.command(&Wanted { name: "debug_nop", fields: &[] }).expect("a command");
    for _ in 0..3000 {
        assert!(link.send(nop.numbers([]).expect("bytes"), None));
    }
    let mut most = 0;
    while !link.is_idle() {
        let out = link.transmit(wires.now_s);
        // One byte more goes before what is sent again, for a board that looks for the end of a frame.
        most = most.max(out.bytes.len());
        let bytes = wires.pass(&out.bytes);
        link.receive(&bytes, wires.now_s);
    }
    assert!((100..=193).contains(&most), "{most}");
    assert!(!ask.is_empty());
}

#[test]
fn a_command_that_is_urgent_goes_first() {
    let mut link = Link::new(0);
    assert!(link.send(vec![1], None) && link.send_urgent(vec![2], Some(9)));
    let bytes = link.transmit(0.0).bytes;
    assert_eq!(bytes[2..4], [2, 1], "in one frame");
    assert!(!link.send(vec![0; 60], None) && !link.send(vec![], None));
}

#[test]
fn on_a_serial_line_a_frame_has_the_time_that_its_bytes_need() {
    let mut link = Link::new(0);
    // 6 bytes of 10 bits in 0.1 s.
    link.paces(600.0);
    assert!(link.send(vec![1], None) && !link.transmit(0.0).bytes.is_empty());
    assert!(link.transmit(0.12).bytes.is_empty(), "it is still on its way");
    assert!(!link.transmit(0.13).bytes.is_empty());
}

#[test]
fn a_frame_without_an_answer_goes_out_again_later_and_later() {
    let mut link = Link::new(0);
    assert!(link.send(vec![1], None));
    let mut sent = Vec::new();
    for now_ms in 0..2000 {
        if !link.transmit(f64::from(now_ms) / 1000.0 + 1e-9).bytes.is_empty() {
            sent.push(now_ms);
        }
    }
    let expected = [0, 25, 75, 175, 375, 775, 1575];
    let near = |(sent, expected): (&i32, &i32)| (sent - expected).abs() <= 2;
    assert!(sent.len() == 7 && sent.iter().zip(&expected).all(near), "{sent:?}");
}

#[test]
fn motion_waits_a_moment_for_its_frame_to_be_filled() {
    let mut link = Link::new(0);
    let put = |link: &mut Link| assert!(link.send_motion(vec![7; 6], 0));
    put(&mut link);
    assert!(link.transmit(0.0).bytes.is_empty());
    let due_s = link.due_s();
    assert!((0.02..0.03).contains(&due_s), "{due_s}");
    put(&mut link);
    assert!(link.transmit(0.5 * due_s).bytes.is_empty());
    // Both in one frame, once the first has waited.
    assert_eq!(link.transmit(due_s).bytes.len(), 5 + 12);
    // A frame that is full goes at once, and what is left waits.
    (0..10).for_each(|_| put(&mut link));
    assert_eq!(link.transmit(due_s).bytes.len(), 5 + 54);
    assert!(link.due_s() > due_s);
    // So does what is in a hurry, and what goes before it.
    link.hurry();
    assert_eq!(link.transmit(due_s).bytes.len(), 5 + 6);
    put(&mut link);
    assert!(link.send_urgent(vec![9], None));
    assert_eq!(link.transmit(due_s).bytes.len(), 5 + 7);
}
