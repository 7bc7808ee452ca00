//! Part files that are run, shown, looked for and made from others.

use super::conversion;
use crate::run::FileParameters;
use crate::run::levels;
use crate::run::questions;
use crate::run::registry;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::act::File;
use kerf_program::{Button, FileRequest, Folder, QuestionKind};

/// Carries a file command out.
pub(super) fn run(c: &mut Context<'_>, act: File, a: &Arguments) -> Result<(), Stop> {
    match act {
        File::Run => call(c, a, parameters(a)),
        File::StepThrough => call(c, a, FileParameters { stepped: true, ..parameters(a) }),
        File::Edit => {
            let name = match a.text(0) {
                Some(name) => name.trim().to_string(),
                None => registry::last_part_file(c.host),
            };
            edit(c, &name)
        }
        File::New => edit(c, ""),
        File::Folder => set_folder(c, a),
        File::Convert => conversion::convert(c, a),
    }
}

fn call(c: &mut Context<'_>, a: &Arguments, parameters: FileParameters) -> Result<(), Stop> {
    let name = a.text(0).unwrap_or_default().trim().to_string();
    levels::call_file(c, FileRequest { folder: Folder::Parts, name }, parameters)
}

fn parameters(a: &Arguments) -> FileParameters {
    let present = |index| a.flag(index).unwrap_or_default();
    FileParameters {
        proportion: std::array::from_fn(|i| a.number_or(1 + i, 1.0)),
        repetitions: (a.number_or(4, 1.0) as u32).max(1),
        offset: a.number_or(5, 0.0) as u8,
        plunge_mm: a.number_or(6, 0.0),
        tabs: present(7),
        plunge_from_zero: present(8),
        ..FileParameters::default()
    }
}

pub(super) fn edit(c: &mut Context<'_>, name: &str) -> Result<(), Stop> {
    let question = questions::question(c, QuestionKind::Editor, name, &[Button::OK]);
    c.ask(&question).map(drop)
}

fn set_folder(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let folder = a.text(0);
    if let Some(mask) = a.text(1) {
        c.host.set_file_mask(mask.trim());
    }
    if folder.is_none() && a.given(1) {
        return Ok(());
    }
    let set = c.host.set_part_folder(folder.as_deref().map(str::trim));
    set.map(drop).map_err(|e| c.refused(e))
}
