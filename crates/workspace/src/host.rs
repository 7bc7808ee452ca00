//! Answers that every host gives in the same way: files, folders and values that survive are those of its workspace.

/// The methods of `Host` that go to the field `workspace`, for an implementation of it.
#[macro_export]
macro_rules! answered_by_the_workspace {
    () => {
        fn source(
            &mut self,
            request: &kerf_program::FileRequest,
        ) -> Result<kerf_program::SourceFile, kerf_program::HostError> {
            self.workspace.source(request)
        }

        fn set_part_folder(
            &mut self,
            folder: Option<&str>,
        ) -> Result<String, kerf_program::HostError> {
            self.workspace.enter(folder)
        }

        fn set_file_mask(&mut self, mask: &str) {
            self.workspace.set_mask(Some(mask));
        }

        fn file_mask(&mut self) -> String {
            self.workspace.mask().to_owned()
        }

        fn full_path(&mut self, name: &str) -> String {
            self.workspace.full_path(name)
        }

        fn open(
            &mut self,
            number: u8,
            path: &str,
            mode: kerf_program::FileMode,
        ) -> Result<String, kerf_program::HostError> {
            self.workspace.open(number, path, mode)
        }

        fn write(&mut self, number: u8, text: &str) -> Result<(), kerf_program::HostError> {
            self.workspace.write(number, text)
        }

        fn read_line(&mut self, number: u8) -> Result<String, kerf_program::HostError> {
            self.workspace.read_line(number)
        }

        fn close(&mut self, number: u8) -> Result<(), kerf_program::HostError> {
            self.workspace.close(number)
        }

        fn stored(&mut self, key: &str) -> Option<String> {
            self.workspace.value(key)
        }

        fn store(&mut self, key: &str, value: Option<&str>) {
            self.workspace.set_value(key, value);
        }

        fn shell(
            &mut self,
            call: &kerf_program::ShellCall,
        ) -> std::task::Poll<Result<(), kerf_program::HostError>> {
            std::task::Poll::Ready(self.workspace.shell(call))
        }

        fn settings_files(&mut self) -> Vec<String> {
            self.workspace.settings_files()
        }

        fn keep_settings(
            &mut self,
            name: &str,
            text: &str,
        ) -> Result<String, kerf_program::HostError> {
            self.workspace.keep_settings_file(name, text)
        }

        fn user_path(&mut self) -> String {
            self.workspace.user_path()
        }

        fn app_path(&mut self) -> String {
            self.workspace.app_path()
        }
    };
}
