//! `kerf wavlength`: how long a sound lasts, so that a part file can pause for it.

use crate::exit::Exit;
use crate::{given, out};
use anyhow::{Result, bail};
use clap::Args;
use std::path::PathBuf;

/// Tells how long a .wav file plays, in seconds
///
/// PLAY does not wait for the end of a sound; a PAUSE of this length does.
#[derive(Args)]
#[command(after_help = "Example: kerf wavlength ready.wav")]
pub struct WavlengthArgs {
    /// The sound
    file: PathBuf,
}

pub fn run(args: &WavlengthArgs) -> Result<Exit> {
    let name = args.file.display();
    let bytes = given::bytes(&args.file)?;
    let Some(seconds) = seconds(&bytes) else { bail!("{name} is no .wav file") };
    out::print(&format!("{}\n", kerf_program::decimal(seconds, 3)));
    Ok(Exit::Good)
}

/// Bytes of sound over bytes a second. A RIFF file is a row of chunks, each a name of four letters,
/// its length as a little-endian number, and so many bytes, filled up to an even number.
fn seconds(bytes: &[u8]) -> Option<f64> {
    let riff = bytes.get(..4)? == b"RIFF" && bytes.get(8..12)? == b"WAVE";
    let mut rest = riff.then(|| bytes.get(12..))??;
    let mut bytes_a_second = None;
    loop {
        let length = number(rest.get(4..8)?)?;
        let body = rest.get(8..)?;
        match rest.get(..4)? {
            b"fmt " => bytes_a_second = Some(number(body.get(8..12)?)?).filter(|n| *n > 0),
            b"data" => {
                // A recorder that was cut off may promise more than there is.
                let there = length.min(body.len() as u32);
                return Some(f64::from(there) / f64::from(bytes_a_second?));
            }
            _ => {}
        }
        let step = usize::try_from(length).ok()?;
        rest = body.get(step + step % 2..)?;
    }
}

fn number(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}

#[cfg(test)]
mod tests {
    use super::seconds;

    fn chunk(name: &str, bytes: &[u8]) -> Vec<u8> {
        let mut chunk = name.as_bytes().to_vec();
        chunk.extend((bytes.len() as u32).to_le_bytes());
        chunk.extend(bytes);
        chunk.resize(chunk.len() + bytes.len() % 2, 0);
        chunk
    }

    /// 8000 samples a second, two channels of 16 bits.
    fn wav(data: usize) -> Vec<u8> {
        let mut fmt = vec![1, 0, 2, 0];
        fmt.extend(8000_u32.to_le_bytes());
        fmt.extend(32000_u32.to_le_bytes());
        fmt.extend([4, 0, 16, 0]);
        let chunks = [chunk("LIST", b"odd"), chunk("fmt ", &fmt), chunk("data", &vec![0; data])];
        [b"RIFF\0\0\0\0WAVE".to_vec(), chunks.concat()].concat()
    }

    #[test]
    fn length_is_bytes_over_rate() {
        assert_eq!(seconds(&wav(48000)), Some(1.5));
        assert_eq!(seconds(&wav(0)), Some(0.0));
        let whole = wav(48000);
        assert_eq!(seconds(&whole[..whole.len() - 16000]), Some(1.0), "what is there counts");
    }

    #[test]
    fn what_is_no_sound_is_refused() {
        for end in [0, 3, 11, 20, 40] {
            assert_eq!(seconds(&wav(16)[..end]), None, "{end}");
        }
        assert_eq!(seconds(b"RIFX\0\0\0\0WAVE"), None);
    }
}
