//! The serial link of the hand console: keys come in as bytes, the screen goes out.
//!
//! ```text
//!  in    0 … 9  -  CR  F  S  P  U        a byte a key; a key that is held is sent again and again
//!  out   FF, 20 characters, 20 characters   whenever the screen changes, and on Enter
//!        BEL                              a beep
//! ```
//!
//! The console is somebody like a page: it drives when nobody else does, and has to take control first. A port
//! that cannot be opened is tried again, so that the cable may be plugged in at any time.

use crate::app::App;
use crate::locks::lock;
use crate::people::Grip;
use crate::priority::Yields;
use kerf_handconsole::{Key, Screen};
use kerf_transport::{LineError, Port};
use kerf_wire::{Change, HandConsole, Role, Tone, Who};
use std::sync::{Arc, Weak};
use std::thread;
use std::time::{Duration, Instant};

/// Time to wait for the bytes of keys before the screen is looked at again.
const LOOK: Duration = Duration::from_millis(15);

/// Interval between two attempts to open the port.
const AGAIN: Duration = Duration::from_secs(2);

/// Bits on the line of a byte.
const BITS: f64 = 10.0;

/// Byte that makes the console beep.
const BELL: u8 = 0x07;

/// Begins the thread of the link, which ends with the server.
pub fn begin(app: &Arc<App>) {
    let app = Arc::downgrade(app);
    let thread = thread::Builder::new().name("hand console's link".into());
    // Without threads nothing of the server works, which is told elsewhere.
    drop(thread.spawn(move || {
        Yields::Front.hold();
        keep_open(&app);
    }));
}

/// The device of the hand console and its rate, where there is one.
fn device(app: &App) -> Option<(String, u32)> {
    let machine = lock(&app.left).session.configuration();
    let device =
        machine.device(machine.options.console_port).filter(|_| machine.options.console)?;
    Some((device.to_owned(), machine.options.console_baud))
}

fn keep_open(app: &Weak<App>) {
    while let Some(alive) = app.upgrade() {
        match device(&alive).map(|(path, baud)| (Port::open(&path, baud), (path, baud))) {
            None => tell(&alive, String::new()),
            Some((Err(error), _)) => warn(&alive, &error),
            Some((Ok(port), device)) => {
                let link = Link::new(&alive, port, device);
                drop(alive);
                link.serve(app);
            }
        }
        thread::sleep(AGAIN);
    }
}

/// Tells why there is no link; people read it once.
fn warn(app: &App, why: &LineError) {
    let why = why.to_string();
    if app.hub.read(|now| now.hand_console.link != why) {
        app.hub.say(Tone::Warning, format!("hand console: {why}"));
        tell(app, why);
    }
}

/// Tells pages how the link is.
fn tell(app: &App, link: String) {
    app.hub.changing(|now| {
        let hand_console = HandConsole { link, ..now.hand_console.clone() };
        let other = now.hand_console != hand_console;
        other.then_some(Change::HandConsole { hand_console }).into_iter().collect()
    });
}

/// An open link, and what is known of who is at its end.
struct Link {
    port: Port,
    device: (String, u32),
    who: Who,
    /// Number of the key pressed last.
    seq: u64,
    last: Option<Key>,
    /// Screen that was sent last.
    drawn: Option<Screen>,
    beeps: u32,
    /// Until then the line is busy with what was sent.
    busy_until: Instant,
}

impl Link {
    fn new(app: &App, port: Port, device: (String, u32)) -> Self {
        let who = app.pages.enter_by_cable(Role::Setter, "hand console".into());
        app.driving.tell_clients();
        tell(app, format!("at {}", device.0));
        let beeps = app.hub.read(|now| now.hand_console.beeps);
        let (drawn, last, busy_until) = (None, None, Instant::now());
        Self { port, device, who, seq: 0, last, drawn, beeps, busy_until }
    }

    /// Carries keys and screens until the server ends, the port is gone or another one is set.
    fn serve(mut self, app: &Weak<App>) {
        let mut lost = None;
        while let Some(app) = app.upgrade()
            && lost.is_none()
            && device(&app).as_ref() == Some(&self.device)
        {
            lost = self.listen(&app).and_then(|()| self.draw(&app)).err();
        }
        let Some(app) = app.upgrade() else { return };
        app.pages.remove(self.who.client);
        app.driving.gone(self.who.client);
        app.driving.tell_clients();
        lost.iter().for_each(|why| warn(&app, why));
    }

    fn listen(&mut self, app: &App) -> Result<(), LineError> {
        let mut bytes = [0; 64];
        let count = self.port.read(&mut bytes, LOOK)?;
        // Noise on the line is no key.
        bytes[..count].iter().filter_map(|byte| Key::of(char::from(*byte))).for_each(|key| {
            self.key(app, key);
        });
        Ok(())
    }

    /// A key that moves the tool and comes again is held.
    fn key(&mut self, app: &App, key: Key) {
        let again = self.last.replace(key) == Some(key);
        if again && app.hands.renew(&self.who, self.grip(app)).is_ok() {
            return;
        }
        self.seq += 1;
        if key == Key::Enter {
            self.drawn = None;
        }
        // It fails where the thread of the console has ended, and with it the server.
        drop(app.keys.press(&app.hears(&self.who), self.grip(app), key.character()));
    }

    /// The sign of a hand that is nearer than any link.
    fn grip(&self, app: &App) -> Grip {
        Grip { seq: self.seq, at: app.clock.now() }
    }

    /// Sends the screen where it is another, as soon as the line is free.
    fn draw(&mut self, app: &App) -> Result<(), LineError> {
        if Instant::now() < self.busy_until {
            return Ok(());
        }
        let HandConsole { lines, beeps, .. } = app.hub.read(|now| now.hand_console.clone());
        let (screen, mut bytes) = (Screen { lines }, Vec::new());
        if self.drawn.as_ref() != Some(&screen) {
            bytes.extend(screen.bytes());
            self.drawn = Some(screen);
        }
        if std::mem::replace(&mut self.beeps, beeps) != beeps {
            bytes.push(BELL);
        }
        let takes_s = bytes.len() as f64 * BITS / f64::from(self.device.1);
        self.busy_until = Instant::now() + Duration::from_secs_f64(takes_s);
        if bytes.is_empty() { Ok(()) } else { self.port.write(&bytes) }
    }
}
