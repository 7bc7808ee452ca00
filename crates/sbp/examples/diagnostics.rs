//! Prints what reading and the static checks say about part files: `diagnostics FILE…`.
#![allow(clippy::print_stdout)]

use kerf_program::settings::LinearUnit;

fn main() -> std::io::Result<()> {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path)?;
        let name = path.rsplit('/').next().unwrap_or(&path);
        let program = kerf_sbp::read(name.into(), &bytes);
        let checked = kerf_sbp::check(&program, Some(LinearUnit::Inch));
        for d in program.diagnostics.iter().chain(&checked) {
            let p = &d.place;
            println!("{name}:{}:{}: {} {} [{}]", p.line, p.column, d.code, d.message, d.hint);
            println!("    {}", program.line_text(p.line).trim());
        }
    }
    Ok(())
}
