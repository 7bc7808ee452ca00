//! A fake controller, on a pseudo terminal: to try `kerf run FILE --machine grbl:PORT` without a
//! machine.
//!
//! ```text
//! cargo run -p kerf --example grbl
//! kerf run box.sbp --machine grbl:/dev/pts/4
//! ```
//!
//! Settings are arguments: `20=1 22=1`; `hal` makes it one of grblHAL, `card` one with a card. Lines on standard input work it: `limit` hits a limit switch,
//! `pins PD` closes switches, `block X Y Z X Y Z`, `bore X Y RADIUS` and `plate Z RISE RISE` are things that its
//! probe feels until `nothing`, `pendant G55` sends it a line, `tool` has it change the tool by itself, `file NAME LINE|LINE` puts a file on its
//! card, `runs NAME` has it run one, `card` tells their names, `setting 100` and `where` tell a setting and where it stands, an end of the input unplugs it.
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
    use kerf_driver_grbl::fake::{Board, Fake, Solid};
    use kerf_transport::pretend::Plug;
    use std::io::stdin;
    use std::sync::mpsc::{Receiver, TryRecvError, channel};
    use std::time::{Duration, Instant};

    pub fn main() {
        let settings: Vec<(u16, f64)> =
            std::env::args().skip(1).filter_map(|word| setting(&word)).collect();
        let plug = Plug::new().expect("a pseudo terminal");
        println!("{}", plug.path());
        let (said, says) = channel();
        std::thread::spawn(move || {
            stdin().lines().map_while(Result::ok).try_for_each(|l| said.send(l))
        });
        let is = |kind: &str| std::env::args().any(|word| word == kind);
        let board = match (is("card"), is("hal")) {
            (true, _) => Board::hal_with_card(&[]),
            (false, true) => Board::hal(0),
            (false, false) => Board::grbl(),
        };
        play(plug, Fake::of(board, &settings), &says);
    }

    fn setting(word: &str) -> Option<(u16, f64)> {
        let (number, value) = word.split_once('=')?;
        Some((number.parse().ok()?, value.parse().ok()?))
    }

    fn play(mut plug: Plug, mut fake: Fake, says: &Receiver<String>) {
        let since = Instant::now();
        let mut bytes = [0; 256];
        loop {
            let count =
                plug.read(&mut bytes, Duration::from_millis(2)).expect("the pseudo terminal");
            let now_s = since.elapsed().as_secs_f64();
            fake.hear(&bytes[..count], now_s);
            let out = fake.speak(now_s);
            plug.write(&out).expect("the pseudo terminal");
            match says.try_recv() {
                Ok(line) => work(&mut fake, &line),
                Err(TryRecvError::Empty) => {}
                Err(TryRecvError::Disconnected) => return,
            }
        }
    }

    /// A block by its corners, a bore by its centre and radius, a plate by its height and its rise along X and Y.
    fn solid(word: &str, numbers: &str) -> Option<Solid> {
        let numbers: Option<Vec<f64>> = numbers.split(' ').map(|word| word.parse().ok()).collect();
        match numbers?[..] {
            [height, x, y] if word == "plate" => Some(Solid::Plate { height, rise: [x, y] }),
            [x, y, radius] => Some(Solid::Bore { centre: [x, y], radius }),
            [x0, y0, z0, x, y, z] => Some(Solid::Block { low: [x0, y0, z0], high: [x, y, z] }),
            _ => None,
        }
    }

    fn work(fake: &mut Fake, line: &str) {
        match line.split_once(' ').unwrap_or((line, "")) {
            ("limit", _) => fake.hits_limit(),
            ("pins", pins) => fake.pins(pins),
            ("pendant", line) => {
                fake.hear(format!("{line}\n").as_bytes(), 0.0);
            }
            (word @ ("block" | "bore" | "plate"), numbers) => match solid(word, numbers) {
                Some(solid) => fake.solids.push(solid),
                None => println!("block X Y Z X Y Z, bore X Y RADIUS, plate Z RISE RISE; mm"),
            },
            ("tool", _) => fake.changes_tool(),
            ("nothing", _) => fake.solids.clear(),
            ("where", _) => {
                let [x, y, z, ..] = fake.position().0;
                let (stands, spindle) = (fake.stands(), fake.spindle());
                println!(
                    "{x:.3},{y:.3},{z:.3} spindle {spindle:?}, {stands} stands, {} bytes lost{}",
                    fake.overflowed,
                    if fake.waits_for_tool() { ", waits for a tool" } else { "" }
                );
            }
            ("setting", number) => {
                println!("{}", fake.is_set_to(number.parse().unwrap_or_default()));
            }
            ("file", file) => {
                let (name, lines) = file.split_once(' ').unwrap_or((file, ""));
                let content = format!("{}\n", lines.replace('|', "\n")).into_bytes();
                fake.card().files.insert(name.to_owned(), content);
            }
            ("runs", name) => println!("{}", fake.runs_from_card(name)),
            ("card", _) => {
                let names: Vec<_> = fake.card().files.keys().cloned().collect();
                println!("{}", names.join(" "));
            }
            ("lines", _) => fake.lines.iter().for_each(|line| println!("{line}")),
            _ => println!(
                "limit, pins PXYZD, block, bore, plate, nothing, pendant LINE, tool, file NAME LINE|LINE, runs NAME, card, setting N, where, lines"
            ),
        }
    }
}
