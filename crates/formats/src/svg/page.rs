//! From the units of a file to millimetres, and from one view of a file to another.

use super::length::{Along, Measure};
use super::look::Look;
use kerf_geom::{Point2, Transform2, Vec2};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, ViewBox};

/// Millimetres in a unit of a file that does not tell its size otherwise.
const UNIT_MM: f64 = 25.4 / 96.0;

/// Attribute with the lower left of the page in the drawing it was made from, millimetres, `x,y`: what Kerf writes
/// comes back where it was.
pub const ORIGIN: &str = "data-origin";

/// Properties that the outermost element gives to everything within it.
pub struct Page {
    /// From the units of the file to millimetres with Y upwards, the lower edge of the page at 0.
    pub map: Transform2,
    /// Size that percentages refer to, in units of the file.
    pub room: Option<Vec2>,
    /// The size of the page in pixels.
    pub sheet: Option<Vec2>,
    /// It has a view box and no size.
    pub is_unsized: bool,
}

/// The page. Its own attributes count before styles: those tell how large it is on a screen.
pub fn page(look: &Look, measure: &Measure) -> Page {
    let root = look.node;
    let size = |name| {
        let text = root.attribute(name).or_else(|| look.styled(name))?;
        measure.units(text, Along::of(name)).ok().filter(|size| *size > 0.0)
    };
    let (width, height) = (size("width"), size("height"));
    let box_of = view_box(root);
    let (view, sheet) = match box_of {
        None => (Transform2::IDENTITY, width.zip(height).map(|(w, h)| Vec2::new(w, h))),
        Some(view) => {
            let wide = width.or(height.map(|tall| tall * view.w / view.h)).unwrap_or(view.w);
            let tall = height.unwrap_or(wide * view.h / view.w);
            (fitted(root, view, wide, tall), Some(Vec2::new(wide, tall)))
        }
    };
    let tall = sheet.map(|sheet| sheet.y).or(height).unwrap_or_default();
    let flip = Transform2::scaled(Point2::default(), UNIT_MM, -UNIT_MM);
    let lower_left = origin(root) + Vec2::new(0.0, tall * UNIT_MM);
    Page {
        map: view.then(&flip).then(&Transform2::moved(lower_left - Point2::default())),
        room: box_of.map(|view| Vec2::new(view.w, view.h)).or(sheet),
        sheet,
        is_unsized: box_of.is_some() && width.or(height).is_none(),
    }
}

fn origin(root: Node) -> Point2 {
    let words = root.attribute(ORIGIN).and_then(|text| text.split_once(','));
    let place = words.and_then(|(x, y)| Some((x.trim().parse().ok()?, y.trim().parse().ok()?)));
    let near = place.filter(|(x, y): &(f64, f64)| x.is_finite() && y.is_finite());
    near.map_or(Point2::default(), |(x, y)| Point2::new(x, y))
}

/// Returns what a symbol or an SVG within an SVG is moved and scaled by, and how large it is to what stands in it:
/// `user` tells where it stands and how large it is, itself or the `use` that draws it.
///
/// # Errors
/// A length in it cannot be read, or it has no size.
pub fn inner(
    look: &Look,
    user: &Look,
    measure: &Measure,
) -> Result<(Transform2, Option<Vec2>), String> {
    let is_svg = look.node.tag_name().name() == "svg";
    let place = |name| if is_svg { look.length(name, measure) } else { Ok(None) };
    let by = Vec2::new(place("x")?.unwrap_or_default(), place("y")?.unwrap_or_default());
    let size = |name| {
        let asked = user.length(name, measure)?;
        let found = if asked.is_some() { asked } else { look.length(name, measure)? };
        let none = || format!("<{}> without a size", user.node.tag_name().name());
        found.map(|size| if size > 0.0 { Ok(size) } else { Err(none()) }).transpose()
    };
    // Without a size it fills what it stands in, whose size may not be known: then nothing is scaled.
    let room = measure.room;
    let wide = size("width")?.or(room.map(|room| room.x));
    let tall = size("height")?.or(room.map(|room| room.y));
    let own = Transform2::moved(by);
    let Some(view) = view_box(look.node) else {
        return Ok((own, wide.zip(tall).map(|(w, h)| Vec2::new(w, h))));
    };
    let map = fitted(look.node, view, wide.unwrap_or(view.w), tall.unwrap_or(view.h));
    Ok((map.then(&own), Some(Vec2::new(view.w, view.h))))
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

/// Returns the shares of the spare room to the left, and above.
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
