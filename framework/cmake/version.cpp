namespace similitude {
/// The program's version, for manifests and `similitude --version`.
const char* program_version() { return "0.1.0"; }
}  // namespace similitude
