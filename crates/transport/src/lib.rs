//! Lines of bytes: controllers, the hand console and jobs sent by cable speak through them.
//!
//! A [`Line`] moves bytes; what they mean is its owner's affair. A [`Port`] is a serial one, used with 8 data bits, no
//! parity and 1 stop bit, without flow control: what all these speak. [`Tcp`] and [`WebSocket`] reach controllers in the
//! network; a `Child` is a program that is started. An [`Address`] is what people call such a line, and opens it.
//!
//! ```no_run
//! # fn main() -> Result<(), kerf_transport::LineError> {
//! use kerf_transport::{Line, Port};
//! use std::time::Duration;
//! let mut port = Port::open("/dev/ttyUSB0", 115_200)?;
//! port.write(b"?")?;
//! let mut bytes = [0; 128];
//! let count = port.read(&mut bytes, Duration::from_millis(100))?;
//! println!("{:?}", &bytes[..count]);
//! # Ok(())
//! # }
//! ```
//!
//! Where there is nothing to plug in, [`pretend`] makes ports with something behind them: a program
//! ([`pretend::Plug`]) or another port ([`pretend::Cable`]). [`Faulty`] loses, doubles and spoils what passes.

mod address;
#[cfg(unix)]
mod child;
mod error;
mod faulty;
mod line;
mod port;
#[cfg(unix)]
pub mod pretend;
mod tcp;
mod websocket;

pub use address::Address;
#[cfg(unix)]
pub use child::Child;
pub use error::LineError;
pub use faulty::{Damage, Fault, Faulty};
pub use line::Line;
pub use port::{ListedPort, Port, listed_ports, ports, serial_number};
pub use tcp::Tcp;
pub use websocket::WebSocket;
