//! Serial ports: controllers, the hand console and jobs sent by cable speak through them.
//!
//! A [`Port`] is opened by its path and moves bytes; what they mean is its owner's affair. Every port is
//! used with 8 data bits, no parity and 1 stop bit, without flow control: what all these speak.
//!
//! ```no_run
//! # fn main() -> Result<(), kerf_serial::SerialError> {
//! use std::time::Duration;
//! let mut port = kerf_serial::Port::open("/dev/ttyUSB0", 115_200)?;
//! port.write(b"?")?;
//! let mut bytes = [0; 128];
//! let count = port.read(&mut bytes, Duration::from_millis(100))?;
//! println!("{:?}", &bytes[..count]);
//! # Ok(())
//! # }
//! ```
//!
//! Where there is nothing to plug in, [`pretend`] makes ports with something behind them: a program
//! ([`pretend::Plug`]) or another port ([`pretend::Cable`]).

mod error;
mod port;
#[cfg(unix)]
pub mod pretend;

pub use error::SerialError;
pub use port::Port;
