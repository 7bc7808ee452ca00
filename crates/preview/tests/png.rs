//! The PNG decoded: its size, and ink where the path is.

use crate::common;
use crate::common::{cut, scene};
use kerf_preview::{Options, Scene, png, svg};
use tiny_skia::Pixmap;

fn paint(scene: &Scene, pixels: u32) -> Pixmap {
    let bytes = png(scene, &Options { pixels, ..Options::default() }).unwrap();
    Pixmap::decode_png(&bytes).unwrap()
}

/// Colour of the picture at a working place, found by the numbers of the SVG.
fn pixel_of(scene: &Scene, picture: &Pixmap, [x, y]: [f64; 2]) -> [u8; 3] {
    let text = svg(scene, &Options::default());
    let doc = roxmltree::Document::parse(&text).unwrap();
    let view: Vec<f64> = doc
        .root_element()
        .attribute("viewBox")
        .unwrap()
        .split(' ')
        .map(|v| v.parse().unwrap())
        .collect();
    let scale = f64::from(picture.width()) / view[2];
    let at = [(x - view[0]) * scale, (-y - view[1]) * scale].map(|v| v as u32);
    let p = picture.pixel(at[0], at[1]).unwrap();
    [p.red(), p.green(), p.blue()]
}

#[test]
fn the_longer_side_has_the_wished_length() {
    for pixels in [300, 1600] {
        let picture = paint(&common::plate(), pixels);
        assert_eq!(picture.width().max(picture.height()), pixels);
        assert!(picture.width().min(picture.height()) > pixels / 3);
    }
}

#[test]
fn ink_is_where_the_path_is_and_nowhere_else() {
    let scene = scene(vec![
        cut([0.0, 0.0, -1.0], [80.0, 0.0, -1.0]),
        common::arc([80.0, 0.0, -1.0], [40.0, 0.0], std::f64::consts::PI, -9.0),
    ]);
    let picture = paint(&scene, 1200);
    let dark = |at: [f64; 2]| pixel_of(&scene, &picture, at).iter().any(|v| *v < 190);
    let round = |r: f64, i: u32| {
        let (s, c) = (0.05 * f64::from(i)).sin_cos();
        [40.0 + r * c, r * s]
    };
    // White rims of arrows hide a little of the path.
    let on = (1..60).filter(|i| dark(round(40.0, *i))).count();
    assert!(on > 50, "{on} of 59 places on the arc have ink");
    let off = (1..60).filter(|i| dark(round(37.5, *i)) || dark(round(42.5, *i))).count();
    assert_eq!(off, 0, "beside the arc");
    assert!(dark([31.0, 0.0]) && !dark([31.0, 4.0]) && !dark([40.0, 20.0]));
}

#[test]
fn odd_numbers_and_empty_scenes_give_a_picture() {
    for scene in [Scene::default(), common::odd()] {
        assert_eq!(paint(&scene, 200).width().max(paint(&scene, 200).height()), 200);
    }
}

#[test]
fn a_size_that_does_not_fit_is_an_error() {
    for pixels in [0, u32::MAX] {
        let error = png(&common::plate(), &Options { pixels, ..Options::default() }).unwrap_err();
        assert!(error.to_string().contains("choose another size"), "{error}");
    }
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let draw = || png(&common::plate(), &Options { pixels: 400, ..Options::default() }).unwrap();
    assert_eq!(draw(), draw());
}
