//! A host for examples and tests: agrees with everything, reads files beside the program.

use kerf_program::testing::Bystander;
use kerf_program::{
    Answer, Button, FileMode, FileRequest, Folder, HostError, Question, SourceFile,
};
use std::path::PathBuf;
use std::task::Poll;

/// A host that agrees with everything and reads files beside the program.
#[derive(Debug, Default)]
pub struct Quiet(pub PathBuf);

impl Bystander for Quiet {
    fn ask(&mut self, _: &Question) -> Poll<Answer> {
        Poll::Ready(Answer::Button(Button::OK))
    }
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let folder = match request.folder {
            Folder::Parts | Folder::Settings | Folder::Media => self.0.clone(),
            // The custom cuts that Kerf ships.
            Folder::Custom => {
                PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../files/custom"))
            }
        };
        let bytes = std::fs::read(folder.join(&request.name));
        let bytes = bytes.map_err(|e| HostError::NotFound(e.to_string()))?;
        Ok(SourceFile { name: request.name.as_str().into(), bytes: bytes.into() })
    }
    fn open(&mut self, _: u8, path: &str, _: FileMode) -> Result<String, HostError> {
        Err(HostError::NotAllowed(path.into()))
    }
}
