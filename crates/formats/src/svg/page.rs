//! From the units of a file to millimetres, and from one view of a file to another.

use super::shapes::{length, number};
use crate::finding::Findings;
use kerf_geom::{Point2, Transform2, Vec2};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, ViewBox};

/// Millimetres in a unit of a file that does not tell its size otherwise.
const UNIT_MM: f64 = 25.4 / 96.0;

/// Where the lower left of the page lies in the drawing it was made from, millimetres, `x,y`: what Kerf writes
/// comes back where it was.
pub const ORIGIN: &str = "data-origin";

/// From the units of the file to millimetres with Y upwards, the lower edge of the page at 0.
pub fn page(root: Node, findings: &mut Findings) -> Transform2 {
    let size = |name| root.attribute(name).and_then(length).filter(|size| *size > 0.0);
    let (width, height) = (size("width"), size("height"));
    let (view, tall) = match view_box(root) {
        None => (Transform2::IDENTITY, height.unwrap_or_default()),
        Some(view) => {
            if width.or(height).is_none() {
                findings.note("size", 1, "no width in mm or inches: 96 units to the inch");
            }
            let wide = width.or(height.map(|tall| tall * view.w / view.h)).unwrap_or(view.w);
            let tall = height.unwrap_or(wide * view.h / view.w);
            (fitted(root, view, wide, tall), tall)
        }
    };
    let flip = Transform2::scaled(Point2::default(), UNIT_MM, -UNIT_MM);
    let lower_left = origin(root) + Vec2::new(0.0, tall * UNIT_MM);
    view.then(&flip).then(&Transform2::moved(lower_left - Point2::default()))
}

fn origin(root: Node) -> Point2 {
    let words = root.attribute(ORIGIN).and_then(|text| text.split_once(','));
    let place = words.and_then(|(x, y)| Some((x.trim().parse().ok()?, y.trim().parse().ok()?)));
    let near = place.filter(|(x, y): &(f64, f64)| x.is_finite() && y.is_finite());
    near.map_or(Point2::default(), |(x, y)| Point2::new(x, y))
}

/// What a symbol or an SVG within an SVG is moved and scaled by: `user` tells where it stands and how large
/// it is, itself or the `use` that draws it.
pub fn inner(node: Node, user: Node) -> Transform2 {
    let place = |name| if node == user { number(node, name).unwrap_or_default() } else { 0.0 };
    let own = Transform2::moved(Vec2::new(place("x"), place("y")));
    let Some(view) = view_box(node) else { return own };
    let size = |name| number(user, name).or_else(|| number(node, name)).filter(|size| *size > 0.0);
    // Without a size it is as large as what it stands in, which is not known here: then nothing is scaled.
    let (wide, tall) = (size("width").unwrap_or(view.w), size("height").unwrap_or(view.h));
    fitted(node, view, wide, tall).then(&own)
}

fn view_box(node: Node) -> Option<ViewBox> {
    let found = node.attribute("viewBox").and_then(|text| text.parse::<ViewBox>().ok());
    found.filter(|view| view.w > 0.0 && view.h > 0.0)
}

/// A view box in its room, as large as fits and in the middle unless the file says otherwise.
fn fitted(node: Node, view: ViewBox, wide: f64, tall: f64) -> Transform2 {
    let aspect = node.attribute("preserveAspectRatio");
    let aspect = aspect.and_then(|text| text.parse::<AspectRatio>().ok()).unwrap_or_default();
    let (across, up) = (wide / view.w, tall / view.h);
    let (x, y) = match aspect.align {
        Align::None => (across, up),
        _ if aspect.slice => (across.max(up), across.max(up)),
        _ => (across.min(up), across.min(up)),
    };
    let (left, top) = shares(aspect.align);
    let spare = Vec2::new((wide - x * view.w) * left, (tall - y * view.h) * top);
    let to_corner = Transform2::moved(Vec2::new(-view.x, -view.y));
    let scaled = to_corner.then(&Transform2::scaled(Point2::default(), x, y));
    scaled.then(&Transform2::moved(spare))
}

/// How much of the spare room is to the left, and above.
fn shares(align: Align) -> (f64, f64) {
    use Align as A;
    let left = match align {
        A::None | A::XMinYMin | A::XMinYMid | A::XMinYMax => 0.0,
        A::XMidYMin | A::XMidYMid | A::XMidYMax => 0.5,
        A::XMaxYMin | A::XMaxYMid | A::XMaxYMax => 1.0,
    };
    let top = match align {
        A::None | A::XMinYMin | A::XMidYMin | A::XMaxYMin => 0.0,
        A::XMinYMid | A::XMidYMid | A::XMaxYMid => 0.5,
        A::XMinYMax | A::XMidYMax | A::XMaxYMax => 1.0,
    };
    (left, top)
}
