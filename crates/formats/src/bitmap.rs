//! Pictures: how bright each dot is. BMP, JPEG and PNG.

use image::{ImageReader, Limits};
use std::io::Cursor;
use thiserror::Error;

/// The most dots of a picture: a relief of more would take days.
pub const MOST_DOTS: u64 = 40_000_000;

/// A picture in grey.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bitmap {
    /// Dots from left to right.
    pub columns: usize,
    /// Rows from the top downwards.
    pub rows: usize,
    /// Brightness of each dot, 0 black … 1 white, row by row from the top.
    pub grey: Vec<f32>,
}

/// Reason why a picture cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum BitmapError {
    /// The bytes are no picture of these kinds, or a broken one.
    #[error("the picture cannot be read: {0}")]
    Unreadable(String),
    /// It is larger than anybody can cut.
    #[error("{columns} x {rows} dots: 40 million at the most; make the picture smaller")]
    TooLarge {
        /// Dots from left to right.
        columns: u32,
        /// Rows.
        rows: u32,
    },
}

/// Reads a picture. Colours become grey by how bright they look, what is transparent becomes white.
///
/// # Errors
/// The bytes are no picture, or one that is too large.
pub fn read(bytes: &[u8]) -> Result<Bitmap, BitmapError> {
    let told = |error: &dyn std::fmt::Display| BitmapError::Unreadable(error.to_string());
    let reader = || ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let size = reader().map_err(|e| told(&e))?.into_dimensions().map_err(|e| told(&e))?;
    if u64::from(size.0) * u64::from(size.1) > MOST_DOTS {
        return Err(BitmapError::TooLarge { columns: size.0, rows: size.1 });
    }
    let mut reader = reader().map_err(|e| told(&e))?;
    reader.limits(Limits::default());
    let picture = reader.decode().map_err(|e| told(&e))?.into_luma_alpha16();
    let full = f32::from(u16::MAX);
    let grey = |dot: &image::LumaA<u16>| {
        let [grey, alpha] = dot.0.map(|part| f32::from(part) / full);
        grey * alpha + (1.0 - alpha)
    };
    let grey = picture.pixels().map(grey).collect();
    Ok(Bitmap { columns: size.0 as usize, rows: size.1 as usize, grey })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A BMP of 24 bits, rows from the top.
    fn bmp(columns: u32, rows: u32, dots: &[u8]) -> Vec<u8> {
        let stride = (columns * 3).next_multiple_of(4);
        let mut bytes = b"BM".to_vec();
        // A picture too large has a length that no longer fits; nobody reads it.
        for word in [
            54_u32.wrapping_add(stride.wrapping_mul(rows)),
            0,
            54,
            40,
            columns,
            rows,
            0x0018_0001,
            0,
            0,
            0,
            0,
            0,
            0,
        ] {
            bytes.extend(word.to_le_bytes());
        }
        for row in dots.chunks(columns as usize).rev() {
            let start = bytes.len();
            row.iter().for_each(|dot| bytes.extend([*dot; 3]));
            bytes.resize(start + stride as usize, 0);
        }
        bytes
    }

    #[test]
    fn dots_are_read_from_the_top() {
        let read = read(&bmp(2, 2, &[0, 255, 51, 102])).unwrap();
        assert_eq!((read.columns, read.rows), (2, 2));
        assert_eq!(read.grey, [0.0, 1.0, 0.2, 0.4]);
    }

    #[test]
    fn what_is_no_picture_is_told() {
        assert!(matches!(read(b"Dear Sir"), Err(BitmapError::Unreadable(_))));
        assert!(matches!(read(&bmp(2, 2, &[0; 4])[..60]), Err(BitmapError::Unreadable(_))));
        let told = read(&bmp(40_000, 40_000, &[])).unwrap_err().to_string();
        assert_eq!(told, "40000 x 40000 dots: 40 million at the most; make the picture smaller");
    }
}
