//! The trait of everything through which bytes pass both ways.

use crate::{LineError, Port};
use std::cell::RefCell;
use std::rc::Rc;
use std::time::Duration;

/// A line that takes no byte for so long is gone. The slowest serial rate takes 250 bytes in this time.
pub(crate) const STUCK: Duration = Duration::from_secs(1);

/// A line of bytes, open.
pub trait Line {
    /// Returns the number of bytes that came, waiting for the first of them at most so long; 0 when none did.
    ///
    /// # Errors
    /// The line is gone.
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError>;

    /// Sends all bytes; they may be still on their way when it returns.
    ///
    /// # Errors
    /// The line is gone.
    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError>;

    /// Returns the bits that it takes a second, baud, a byte being ten; nothing where it is as fast as what hangs on it.
    fn rate(&self) -> Option<u32> {
        None
    }
}

impl<L: Line + ?Sized> Line for Box<L> {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        (**self).read(into, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        (**self).write(bytes)
    }

    fn rate(&self) -> Option<u32> {
        (**self).rate()
    }
}

/// A line that its owner shares with whoever works on it from outside.
impl<L: Line> Line for Rc<RefCell<L>> {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        self.borrow_mut().read(into, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        self.borrow_mut().write(bytes)
    }

    fn rate(&self) -> Option<u32> {
        self.borrow().rate()
    }
}

impl Line for Port {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        Self::read(self, into, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        Self::write(self, bytes)
    }

    fn rate(&self) -> Option<u32> {
        Self::rate(self)
    }
}
