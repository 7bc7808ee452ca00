//! The curve of a smoothed segment: a cubic through both ends with given directions there.
//!
//! Its handles are those of the cubic that touches a circle at both ends and in the middle, for the
//! angle between the two directions; so segments of a circle come out round within 10⁻⁴ of their
//! height.

/// A place, a direction or a derivative in X, Y and Z.
pub(crate) type Vec3 = [f64; 3];

/// A cubic from one place to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spline {
    from: Vec3,
    to: Vec3,
    /// Derivatives by the share at both ends.
    start: Vec3,
    end: Vec3,
}

impl Spline {
    /// A curve with these directions at its ends, of length 1.
    pub fn new(from: Vec3, to: Vec3, start: Vec3, end: Vec3) -> Self {
        let chord = length(minus(to, from));
        let cos = dot(start, end).clamp(-1.0, 1.0);
        // cos²(θ/4) for the angle θ between the ends.
        let square = 0.5 * (1.0 + (0.5 * (1.0 + cos)).sqrt());
        let handle = chord / square;
        Self { from, to, start: scaled(start, handle), end: scaled(end, handle) }
    }

    /// Place, derivative and second derivative at a share 0 … 1.
    pub fn at(&self, u: f64) -> [Vec3; 3] {
        let (u2, u3) = (u * u, u * u * u);
        let mix = |a: f64, b: f64, c: f64, d: f64| -> Vec3 {
            std::array::from_fn(|k| {
                a * self.from[k] + b * self.to[k] + c * self.start[k] + d * self.end[k]
            })
        };
        let h = 3.0 * u2 - 2.0 * u3;
        let slope = 6.0 * (u - u2);
        let bend = 6.0 - 12.0 * u;
        [
            mix(1.0 - h, h, u3 - 2.0 * u2 + u, u3 - u2),
            mix(-slope, slope, 3.0 * u2 - 4.0 * u + 1.0, 3.0 * u2 - 2.0 * u),
            mix(-bend, bend, 6.0 * u - 4.0, 6.0 * u - 2.0),
        ]
    }

    /// Length over so many of the first axes, mm, by Gauss's rule of five places.
    pub fn length(&self, axes: usize) -> f64 {
        const PLACES: [(f64, f64); 3] = [
            (0.0, 0.568_888_888_888_889),
            (0.538_469_310_105_683, 0.478_628_670_499_366),
            (0.906_179_845_938_664, 0.236_926_885_056_189),
        ];
        let speed = |x: f64| {
            let slope = self.at(0.5 + 0.5 * x)[1];
            slope[..axes].iter().map(|v| v * v).sum::<f64>().sqrt()
        };
        let sides =
            |(x, w): (f64, f64)| if x > 0.0 { w * (speed(x) + speed(-x)) } else { w * speed(x) };
        0.5 * PLACES.into_iter().map(sides).sum::<f64>()
    }

    /// The greatest distance from the straight segment, mm, looked for at the places in between.
    pub fn height(&self) -> f64 {
        const PLACES: u32 = 16;
        let along = minus(self.to, self.from);
        let chord = length(along);
        let off = |u: f64| length(cross(minus(self.at(u)[0], self.from), along)) / chord;
        (1..PLACES).map(|k| off(f64::from(k) / f64::from(PLACES))).fold(0.0, f64::max)
    }
}

/// Curvature where a curve has these derivatives, 1/mm.
pub(crate) fn curvature(slope: Vec3, bend: Vec3) -> f64 {
    let speed = length(slope);
    if speed > 0.0 { length(cross(slope, bend)) / (speed * speed * speed) } else { 0.0 }
}

pub(crate) fn minus(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(crate) fn scaled(a: Vec3, by: f64) -> Vec3 {
    a.map(|v| v * by)
}

pub(crate) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// The direction of a vector; `None` without length.
pub(crate) fn unit(a: Vec3) -> Option<Vec3> {
    let length = length(a);
    (length > 0.0).then(|| scaled(a, 1.0 / length))
}

/// The angle between two directions, radians.
pub(crate) fn angle(a: Vec3, b: Vec3) -> f64 {
    length(cross(a, b)).atan2(dot(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A piece of a circle of radius 10.
    fn arc(angle: f64) -> Spline {
        let (s, c) = angle.sin_cos();
        Spline::new([10.0, 0.0, 0.0], [10.0 * c, 10.0 * s, 0.0], [0.0, 1.0, 0.0], [-s, c, 0.0])
    }

    #[test]
    fn segments_of_a_circle_are_round() {
        for degrees in [1.0f64, 5.0, 20.0, 45.0] {
            let angle = degrees.to_radians();
            let spline = arc(angle);
            let height = 10.0 * (1.0 - (0.5 * angle).cos());
            assert!((spline.height() / height - 1.0).abs() < 1e-4, "{degrees}");
            assert!((spline.length(2) / (10.0 * angle) - 1.0).abs() < 1e-4, "{degrees}");
            for u in [0.0, 0.3, 0.5, 1.0] {
                let [place, slope, bend] = spline.at(u);
                assert!((length(place) - 10.0).abs() < 1e-4 * height.max(1e-3), "{degrees}");
                assert!((curvature(slope, bend) * 10.0 - 1.0).abs() < 0.02, "{degrees}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_place() {
        let (spline, u, h) = (arc(0.7), 0.37, 1e-5);
        let [below, here, above] = [u - h, u, u + h].map(|u| spline.at(u));
        for k in 0..3 {
            assert!(((above[0][k] - below[0][k]) / (2.0 * h) - here[1][k]).abs() < 1e-7);
            assert!(((above[1][k] - below[1][k]) / (2.0 * h) - here[2][k]).abs() < 1e-7);
        }
    }
}
