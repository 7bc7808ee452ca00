//! Virtual tools: those of Kerf make files in the folders of the machine, those that somebody added
//! are programs that are started (`virtualtools.ini` in the data folder).

use crate::Workspace;
use crate::fonts::font;
use kerf_program::{FileRequest, Folder, HostError, ShellCall, ToolCall, no_such_tool};
use kerf_tools::{AddIn, FileFolder, Folders, Mistake, Tool, ToolOutput};
use std::cell::RefCell;

/// Name of the file of added tools in the data folder.
pub const ADD_INS: &str = "virtualtools.ini";

/// Workspace as a tool reads it.
struct Reading<'a>(RefCell<&'a mut Workspace>);

impl Folders for Reading<'_> {
    fn text(&self, name: &str) -> Option<String> {
        let request = FileRequest { folder: Folder::Parts, name: name.into() };
        let source = self.0.borrow_mut().source(&request).ok()?;
        Some(String::from_utf8_lossy(&source.bytes).into_owned())
    }

    fn font(&self, name: &str) -> Result<Vec<u8>, String> {
        font(&self.0.borrow(), name)
    }
}

/// Tools that somebody added, and what is wrong with their file: line and words.
pub fn add_ins(workspace: &Workspace) -> (Vec<AddIn>, Vec<(usize, String)>) {
    kerf_tools::add_ins(&workspace.data_text(ADD_INS).unwrap_or_default())
}

/// Starts a tool; returns what a person should know.
pub fn start(
    workspace: &mut Workspace,
    call: &ToolCall,
    metric: bool,
) -> Result<Vec<String>, HostError> {
    if let Some(tool) = kerf_tools::tool(call.letter) {
        let entered = tool.read_line(&call.arguments);
        let told = |found: &Mistake| format!("{}: {}", found.field, found.text);
        let made = use_tool(workspace, tool, &entered, metric)?.map_err(|found| {
            HostError::Refused(found.iter().map(told).collect::<Vec<_>>().join("; "))
        })?;
        let names = made.files.iter().map(|file| format!("{} was written", file.name));
        return Ok(names.chain(made.notes).collect());
    }
    let (added, _) = add_ins(workspace);
    let Some(added) = added.into_iter().find(|tool| tool.letter == call.letter) else {
        return Err(HostError::NotFound(no_such_tool(call.letter)));
    };
    let line = format!("{} {}", added.command, call.arguments).trim_end().to_owned();
    workspace.shell(&ShellCall { line, display: 1, wait: added.wait })?;
    Ok(Vec::new())
}

/// Makes the files of a tool of Kerf and writes them; or what is wrong with what was entered.
///
/// # Errors
/// A file cannot be written.
pub fn use_tool(
    workspace: &mut Workspace,
    tool: &Tool,
    entered: &[(String, String)],
    metric: bool,
) -> Result<Result<ToolOutput, Vec<Mistake>>, HostError> {
    let folders = Reading(RefCell::new(&mut *workspace));
    let made = match tool.make(entered, metric, &folders) {
        Ok(made) => made,
        Err(mistakes) => return Ok(Err(mistakes)),
    };
    for file in &made.files {
        let folder = match file.place {
            FileFolder::Parts => Folder::Parts,
            FileFolder::Custom => Folder::Custom,
        };
        workspace.put_made(folder, &file.name, &file.text)?;
    }
    let first = made.files.first().filter(|file| file.place == FileFolder::Parts);
    workspace.made =
        first.map(|file| workspace.part_folder().join(&file.name).display().to_string());
    Ok(Ok(made))
}
