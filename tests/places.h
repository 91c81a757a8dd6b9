#pragma once

/// Where the tests find their boards. Paths of this machine stand in one small source, so that a compiler cache serves
/// every other one in any folder.
namespace locations {

/// The bundled sample board (resources/sample).
extern const char* const kSample;
/// tests/data: small jobs made for single tests.
extern const char* const kTestData;
/// Real boards that are not part of the repository; the folder may be missing, then tests of them are skipped.
extern const char* const kBoards;
/// tests/fuzz/corpus: inputs that once found something.
extern const char* const kFuzzCorpus;
/// The program itself, for tests of the command line.
extern const char* const kProgram;

/// Does COPPERSCOPE_THOROUGH ask for everything, where a test of every day takes a sample (docs/testing.md)?
[[nodiscard]] bool isThorough();

}  // namespace locations
