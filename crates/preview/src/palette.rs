//! Colours, chosen so that they stay apart for colour-blind readers and in a grey print.
//!
//! Depth runs from a light green-blue to a dark indigo in even steps of perceived lightness, worked
//! out in OKLab (Björn Ottosson, "A perceptual color space for image processing", 2020; matrices
//! from there). Jogs are red as VP asks, and dashed besides.

/// An opaque colour, sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rgb(pub [u8; 3]);

/// Text and strong lines.
pub const INK: Rgb = Rgb([0x1c, 0x23, 0x2b]);
/// Secondary text.
pub const SOFT: Rgb = Rgb([0x5a, 0x64, 0x70]);
/// Sheet.
pub const PAPER: Rgb = Rgb([0xff, 0xff, 0xff]);
/// Around table and drawing.
pub const BOARD: Rgb = Rgb([0xf4, 0xf5, 0xf3]);
/// The table's own grid.
pub const GRID: Rgb = Rgb([0xc6, 0xcc, 0xd0]);
/// The fine grid of the rulers.
pub const FINE: Rgb = Rgb([0xe6, 0xe9, 0xea]);
/// The table's edge and the frames.
pub const EDGE: Rgb = Rgb([0x8d, 0x96, 0x9e]);
/// Jogs (VP).
pub const JOG: Rgb = Rgb([0xd6, 0x28, 0x28]);
/// Cutting moves above the surface.
pub const AIR: Rgb = Rgb([0x9a, 0xa1, 0xa8]);
/// Beginning of a cut.
pub const BEGIN: Rgb = Rgb([0xff, 0xd2, 0x1f]);
/// The X axis, and errors.
pub const AXIS_X: Rgb = Rgb([0xb3, 0x26, 0x1e]);
/// The Y axis.
pub const AXIS_Y: Rgb = Rgb([0x1b, 0x7f, 0x4b]);

impl Rgb {
    /// As CSS writes it.
    pub fn hex(self) -> String {
        let [r, g, b] = self.0;
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// This colour with a share of another.
    pub fn mixed(self, other: Self, share: f64) -> Self {
        let mix = |i: usize| {
            let (a, b) = (f64::from(self.0[i]), f64::from(other.0[i]));
            (a + (b - a) * share).round() as u8
        };
        Self([mix(0), mix(1), mix(2)])
    }
}

/// The colour of a depth: 0 at the surface, 1 at the deepest cut.
pub fn depth_colour(share: f64) -> Rgb {
    let t = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    let lightness = 0.80 - 0.52 * t;
    let chroma = 0.105 + 0.06 * t;
    let hue = (190.0 + 85.0 * t).to_radians();
    from_oklab([lightness, chroma * hue.cos(), chroma * hue.sin()])
}

/// The same on a dark ground: deep cuts are strong in colour rather than dark.
pub fn depth_colour_on_dark(share: f64) -> Rgb {
    let t = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    let chroma = 0.05 + 0.14 * t;
    let hue = (185.0 + 125.0 * t).to_radians();
    from_oklab([0.93 - 0.36 * t, chroma * hue.cos(), chroma * hue.sin()])
}

fn from_oklab([l, a, b]: [f64; 3]) -> Rgb {
    let lms = [
        l + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        l - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        l - 0.089_484_177_5 * a - 1.291_485_548_0 * b,
    ]
    .map(|v| v * v * v);
    let row = |m: [f64; 3]| m[0] * lms[0] + m[1] * lms[1] + m[2] * lms[2];
    let linear = [
        row([4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2]),
        row([-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5]),
        row([-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701_0]),
    ];
    Rgb(linear.map(gamma))
}

fn gamma(linear: f64) -> u8 {
    let v = linear.clamp(0.0, 1.0);
    let coded = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    (coded * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE lightness, worked out from the coded colour by another road than the ramp is made.
    fn cie_lightness(colour: Rgb) -> f64 {
        let [r, g, b] = colour.0.map(|v| {
            let c = f64::from(v) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        116.0 * y.cbrt() - 16.0
    }

    #[test]
    fn depth_darkens_in_even_steps() {
        let steps: Vec<f64> =
            (0..=10).map(|i| cie_lightness(depth_colour(f64::from(i) / 10.0))).collect();
        let mean = (steps[0] - steps[10]) / 10.0;
        assert!(mean > 4.5, "the range is wide enough: {steps:?}");
        for pair in steps.windows(2) {
            let step = pair[0] - pair[1];
            assert!((step / mean - 1.0).abs() < 0.35, "{step} against {mean}: {steps:?}");
        }
    }

    #[test]
    fn odd_depths_have_a_colour() {
        assert_eq!(depth_colour(f64::NAN), depth_colour(0.0));
        assert_eq!(depth_colour(7.0), depth_colour(1.0));
    }
}
