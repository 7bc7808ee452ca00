//! Any bytes as a drawing of every kind: reading never panics, tool paths can be made of what was read or
//! it is told why not, and what is written is read again with as many shapes.
#![no_main]

use kerf_formats::{Imported, bitmap, dxf, hpgl, rsg, svg};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((kind, bytes)) = bytes.split_first() else { return };
    let read: Imported = match kind % 5 {
        0 => dxf::read(bytes, &dxf::Options::default()),
        1 => svg::read(bytes),
        2 => hpgl::read(bytes),
        3 => rsg::read(bytes),
        _ => {
            let _ = bitmap::read(bytes);
            return;
        }
    };
    let drawing = read.drawing;
    if drawing.shapes.len() > 200 {
        return;
    }
    let _ = kerf_toolpath::job(&drawing);
    let again = rsg::read(rsg::write(&drawing).as_bytes()).drawing;
    assert_eq!(again.shapes.len(), drawing.shapes.len());
});
