//! Writes a sheet as SVG.
//!
//! One user unit is a millimetre, and the page's size is given in millimetres, so a print at 100 %
//! is true to scale. Layers in the working frame hang in one mirrored group: the numbers in their
//! paths are the program's own coordinates.

mod path_data;

use crate::font::FAMILY;
use crate::sheet::{Anchor, Frame, Layer, Mark, Paint, Rect, Sheet, Text};
use kerf_geom::Point2;
use path_data::{number, path_data};
use std::fmt::Write as _;

/// The sheet as the text of an SVG file.
pub fn write(sheet: &Sheet) -> String {
    let mut out = String::new();
    head(&mut out, sheet);
    for layer in sheet.layers.iter().filter(|l| !l.marks.is_empty()) {
        write_layer(&mut out, sheet, layer);
    }
    out.push_str("</svg>\n");
    out
}

/// Text that XML takes: the five signs escaped, characters that XML forbids replaced.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(' '),
            c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

fn head(out: &mut String, sheet: &Sheet) {
    let n = |v: f64| number(v, sheet.decimals);
    let page = moved(sheet.page, sheet.origin);
    let (w, h) = (n(page.w), n(page.h));
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"{} {} {w} {h}\" \
         font-family=\"{FAMILY}\">",
        n(page.x),
        n(page.y),
    );
    let _ = writeln!(out, "<title>{}</title>", escape(&sheet.title));
    let _ = writeln!(out, "<desc>{}</desc>", escape(&sheet.description));
    let panel = moved(sheet.panel, sheet.origin);
    let _ = writeln!(
        out,
        "<clipPath id=\"panel\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>",
        n(panel.x),
        n(panel.y),
        n(panel.w),
        n(panel.h)
    );
}

fn moved(rect: Rect, origin: Point2) -> Rect {
    Rect { x: rect.x - origin.x, y: rect.y + origin.y, ..rect }
}

fn write_layer(out: &mut String, sheet: &Sheet, layer: &Layer) {
    let clip = if layer.clip { " clip-path=\"url(#panel)\"" } else { "" };
    let flip = if layer.frame == Frame::Working { " transform=\"scale(1 -1)\"" } else { "" };
    let _ = writeln!(out, "<g id=\"{}\"{clip}>", layer.id);
    let _ =
        writeln!(out, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{flip}>");
    let origin = match layer.frame {
        Frame::Working => sheet.origin,
        Frame::Page => Point2::new(sheet.origin.x, -sheet.origin.y),
    };
    for mark in &layer.marks {
        match mark {
            Mark::Path { outline, paint } => {
                let data = path_data(outline, origin, sheet.decimals);
                let _ = writeln!(out, "<path{} d=\"{data}\"/>", attributes(paint, sheet.decimals));
            }
            Mark::Text(text) => write_text(out, text, origin, sheet.decimals),
        }
    }
    out.push_str("</g>\n</g>\n");
}

fn attributes(paint: &Paint, decimals: u32) -> String {
    let mut out = String::new();
    if let Some(fill) = paint.fill {
        let _ = write!(out, " fill=\"{}\"", fill.hex());
    }
    if let Some(stroke) = paint.stroke {
        let width = number(stroke.width, decimals + 1);
        let _ = write!(out, " stroke=\"{}\" stroke-width=\"{width}\"", stroke.colour.hex());
        if let Some([dash, gap]) = stroke.dash {
            let (dash, gap) = (number(dash, decimals), number(gap, decimals));
            let _ = write!(out, " stroke-dasharray=\"{dash} {gap}\" stroke-linecap=\"butt\"");
        }
    }
    out
}

fn write_text(out: &mut String, text: &Text, origin: Point2, decimals: u32) {
    let (x, y) = (text.at.x - origin.x, text.at.y - origin.y);
    let n = |v: f64| number(v, decimals);
    let anchor = match text.anchor {
        Anchor::Start => "",
        Anchor::Middle => " text-anchor=\"middle\"",
        Anchor::End => " text-anchor=\"end\"",
    };
    let bold = if text.bold { " font-weight=\"bold\"" } else { "" };
    let halo = if text.halo {
        let width = n(0.3 * text.size);
        format!(
            " stroke=\"{}\" stroke-width=\"{width}\" paint-order=\"stroke\"",
            crate::palette::PAPER.hex()
        )
    } else {
        String::new()
    };
    let _ = writeln!(
        out,
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"{anchor}{bold}{halo}>{}</text>",
        n(x),
        n(y),
        n(text.size),
        text.colour.hex(),
        escape(&text.text)
    );
}
