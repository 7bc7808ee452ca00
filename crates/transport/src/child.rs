//! A line to a program that is started for it: its standard input and output.

use crate::line::STUCK;
use crate::port::is_nothing;
use crate::tcp::unreachable;
use crate::{Line, LineError};
use std::io::{ErrorKind, Read, Write};
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::process::{self, Command, Stdio};
use std::time::Duration;

/// A program, running. Its input ends when this is dropped, and it has to end by itself then.
#[derive(Debug)]
pub struct Child {
    name: String,
    /// Taken when it is left alone.
    running: Option<process::Child>,
    stream: UnixStream,
}

impl Child {
    /// Starts a program by its path and arguments, under a name for messages.
    ///
    /// # Errors
    /// It is not there, or may not be run.
    pub fn open(name: &str, words: &[String]) -> Result<Self, LineError> {
        let failed = |error| unreachable(name, &error);
        let (program, arguments) =
            words.split_first().ok_or_else(|| failed(ErrorKind::InvalidInput.into()))?;
        let (stream, theirs) = UnixStream::pair().map_err(failed)?;
        stream.set_write_timeout(Some(STUCK)).map_err(failed)?;
        let out = OwnedFd::from(theirs.try_clone().map_err(failed)?);
        let mut command = Command::new(program);
        command.args(arguments).stdin(OwnedFd::from(theirs)).stdout(out).stderr(Stdio::inherit());
        let running = command.spawn().map_err(failed)?;
        Ok(Self { name: name.to_owned(), running: Some(running), stream })
    }

    fn broken(&self, why: &std::io::Error) -> LineError {
        LineError::Broken { address: self.name.clone(), why: why.to_string() }
    }
}

impl Line for Child {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        let waits = self
            .stream
            .set_nonblocking(wait.is_zero())
            .and_then(|()| self.stream.set_read_timeout(Some(wait).filter(|wait| !wait.is_zero())));
        match waits.and_then(|()| self.stream.read(into)) {
            Ok(0) if !into.is_empty() => Err(self.broken(&ErrorKind::UnexpectedEof.into())),
            Ok(count) => Ok(count),
            Err(error) if is_nothing(error.kind()) => Ok(0),
            Err(error) => Err(self.broken(&error)),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        let waits = self.stream.set_nonblocking(false);
        waits.and_then(|()| self.stream.write_all(bytes)).map_err(|error| self.broken(&error))
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        let _ = self.stream.shutdown(std::net::Shutdown::Both);
        // It may have a machine to stop first: nobody waits for that.
        if let Some(mut running) = self.running.take() {
            std::thread::spawn(move || running.wait());
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn words(words: &[&str]) -> Vec<String> {
        words.iter().map(|word| (*word).to_owned()).collect()
    }

    #[test]
    fn what_a_program_says_comes_back_until_it_ends() {
        let mut child = Child::open("sh", &words(&["sh", "-c", "read a; echo \"<$a>\""])).unwrap();
        let mut bytes = [0; 16];
        assert_eq!(child.read(&mut bytes, Duration::ZERO).unwrap(), 0);
        child.write(b"hello\n").unwrap();
        let count = child.read(&mut bytes, Duration::from_secs(10)).unwrap();
        assert_eq!(&bytes[..count], b"<hello>\n");
        assert!(child.read(&mut bytes, Duration::from_secs(10)).is_err());
        assert!(Child::open("none", &words(&["/no/such/program"])).is_err());
    }
}
