//! A host for examples and tests: agrees with everything, reads files beside the program.

use kerf_program::{
    Answer, Button, FileMode, FileRequest, Folder, Host, HostError, Question, ShellCall, SourceFile,
};
use std::path::PathBuf;
use std::task::Poll;

/// A host that agrees with everything and reads files beside the program.
#[derive(Debug, Default)]
pub struct Quiet(pub PathBuf);

impl Host for Quiet {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }
    fn input(&mut self, _: u8) -> bool {
        false
    }
    fn output(&mut self, _: u8) -> bool {
        false
    }
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
    fn set_part_folder(&mut self, _: Option<&str>) -> Result<String, HostError> {
        Ok(String::new())
    }
    fn open(&mut self, _: u8, path: &str, _: FileMode) -> Result<String, HostError> {
        Err(HostError::NotAllowed(path.into()))
    }
    fn write(&mut self, _: u8, _: &str) -> Result<(), HostError> {
        Ok(())
    }
    fn read_line(&mut self, _: u8) -> Result<String, HostError> {
        Err(HostError::EndOfFile)
    }
    fn close(&mut self, _: u8) -> Result<(), HostError> {
        Ok(())
    }
    fn stored(&mut self, _: &str) -> Option<String> {
        None
    }
    fn store(&mut self, _: &str, _: Option<&str>) {}
    fn shell(&mut self, _: &ShellCall) -> Poll<Result<(), HostError>> {
        Poll::Ready(Ok(()))
    }
    fn machine_position(&mut self) -> [f64; 6] {
        [0.0; 6]
    }
    fn user_path(&mut self) -> String {
        String::new()
    }
    fn app_path(&mut self) -> String {
        String::new()
    }
    fn firmware(&mut self) -> i32 {
        0
    }
}
