//! Prints what the reader says about part files: `diagnostics FILE…`.
#![allow(clippy::print_stdout)]

fn main() -> std::io::Result<()> {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path)?;
        let name = path.rsplit('/').next().unwrap_or(&path);
        let program = kerf_sbp::read(name.into(), &bytes);
        for d in &program.diagnostics {
            let p = &d.place;
            println!("{name}:{}:{}: {} {} [{}]", p.line, p.column, d.code, d.message, d.hint);
            println!("    {}", program.line_text(p.line).trim());
        }
    }
    Ok(())
}
