//! Draws a gallery of scenes into a folder, to be looked at.
//!
//! `cargo run -p kerf-preview --example gallery -- FOLDER [NAME…]`

mod scenes;

use anyhow::{Context, Result};
use std::path::Path;

fn main() -> Result<()> {
    let mut args = std::env::args().skip(1);
    let folder = args.next().context("give a folder for the pictures")?;
    let wanted: Vec<String> = args.collect();
    std::fs::create_dir_all(&folder)?;
    for (name, make) in scenes::ALL {
        if wanted.is_empty() || wanted.iter().any(|w| w == name) {
            draw(Path::new(&folder), name, &make())?;
        }
    }
    Ok(())
}

fn draw(folder: &Path, name: &str, scene: &kerf_preview::Scene) -> Result<()> {
    let options = kerf_preview::Options::default();
    let file = |ending: &str| folder.join(format!("{name}.{ending}"));
    let timed = |what: &str, bytes: usize, since: std::time::Instant| {
        eprintln!(
            "{name:12} {what:5} {:9.3} MB {:7.3} s",
            bytes as f64 / 1e6,
            since.elapsed().as_secs_f64()
        );
    };
    let start = std::time::Instant::now();
    let svg = kerf_preview::svg(scene, &options);
    timed("svg", svg.len(), start);
    std::fs::write(file("svg"), svg)?;
    let start = std::time::Instant::now();
    let png = kerf_preview::png(scene, &options)?;
    timed("png", png.len(), start);
    std::fs::write(file("png"), png)?;
    let start = std::time::Instant::now();
    let html = kerf_preview::html(scene, &options);
    timed("html", html.len(), start);
    std::fs::write(file("html"), html)?;
    Ok(())
}
