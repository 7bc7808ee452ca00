//! A fake board with step queues, on a pseudo terminal: to try `kerf run FILE --machine klipper:PORT` without a
//! machine.
//!
//! ```text
//! cargo run -p kerf --example klipper
//! kerf run box.sbp --machine klipper:/dev/pts/4 --machine board.toml
//! ```
//!
//! It has real-time priority where the system gives that. It may name the longest turn in seconds that the board catches up
//! with on a busy computer; for longer ones its clock stops, so that it is late for nothing. A host whose `board.deadline_s`
//! is 2 sends a second ahead, so 0.5 does there.
//!
//! Lines on standard input work it: `where` tells the counts of its motors and the outputs that are on, `pin N 1` drives a
//! pin, `shut WHY` shuts it down, an end of the input unplugs it.
#![allow(clippy::print_stdout)]

#[cfg(unix)]
fn main() {
    unix::main();
}

#[cfg(not(unix))]
fn main() {
    println!("there are no pseudo terminals here");
}

#[cfg(unix)]
mod unix {
    use kerf_control::controller::queued::raise_priority;
    use kerf_driver_klipper::fake::{Board, Pace};
    use kerf_transport::pretend::Plug;
    use std::io::stdin;
    use std::sync::mpsc::{Receiver, TryRecvError, channel};
    use std::time::{Duration, Instant};

    pub fn main() {
        let plug = Plug::new().expect("a pseudo terminal");
        println!("{}", plug.path());
        let (said, says) = channel();
        std::thread::spawn(move || {
            stdin().lines().map_while(Result::ok).try_for_each(|l| said.send(l))
        });
        let mut board = Board::of_seed(1);
        board.records = false;
        play(plug, board, &says);
    }

    fn play(mut plug: Plug, mut board: Board, says: &Receiver<String>) {
        // A real board does not wait for the computer that it hangs on. Where there is no such priority, its clock waits too.
        drop(raise_priority());
        let turn_s = std::env::args().nth(1).and_then(|turn_s| turn_s.parse().ok());
        let (since, mut pace) = (Instant::now(), turn_s.map_or_else(Pace::default, Pace::of_turn));
        let mut bytes = [0; 256];
        loop {
            let count =
                plug.read(&mut bytes, Duration::from_millis(1)).expect("the pseudo terminal");
            let clock = board.clock_at(pace.at(since.elapsed().as_secs_f64()));
            board.run_to(clock);
            board.feed(&bytes[..count]);
            let out = board.take();
            plug.write(&out).expect("the pseudo terminal");
            match says.try_recv() {
                Ok(line) => work(&mut board, &line),
                Err(TryRecvError::Empty) => {}
                Err(TryRecvError::Disconnected) => return,
            }
        }
    }

    fn work(board: &mut Board, line: &str) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["where"] => {
                let counts: Vec<i64> = board.steppers.values().map(|it| it.position).collect();
                let outputs: Vec<u32> = board.outputs.values().map(|it| it.value).collect();
                let most = board.most_places;
                println!(
                    "counts {counts:?} outputs {outputs:?} places {most} {:?}",
                    board.reason()
                );
            }
            ["pin", pin, level] => {
                let Ok(pin) = pin.parse() else { return println!("pin NUMBER 0 or 1") };
                let now = board.now;
                board.driven.entry(pin).or_default().push((now, level == "1"));
            }
            ["shut", ..] => board.shut(&words[1..].join(" ")),
            _ => println!("where, pin NUMBER 0 or 1, shut WHY"),
        }
    }
}
