#pragma once

#include <filesystem>
#include <initializer_list>
#include <vector>

/// Where the tests find their boards. Paths of this machine stand in one small source, so that a compiler cache serves
/// every other one in any folder.
namespace locations {

/// The bundled sample board (resources/sample).
extern const char* const kSample;
/// tests/data: small jobs made for single tests.
extern const char* const kTestData;
/// tests/fuzz/corpus: inputs that once found something.
extern const char* const kFuzzCorpus;
/// The program itself, for tests of the command line.
extern const char* const kProgram;

/// Whole boards: the folder that COPPERSCOPE_BOARDS names, which is there; without it tests/data/boards. Both are laid
/// out alike (docs/testing.md).
[[nodiscard]] std::filesystem::path boards();
/// All ODB++ jobs of boards(), by name; with the sample, whatever the folder.
[[nodiscard]] std::vector<std::filesystem::path> allBoards();
/// The given boards of boards(): all of them where COPPERSCOPE_BOARDS is set, otherwise those that are bundled.
[[nodiscard]] std::vector<std::filesystem::path> boardsNamed(std::initializer_list<const char*> names);

/// Does COPPERSCOPE_THOROUGH ask for everything, where a test of every day takes a sample (docs/testing.md)?
[[nodiscard]] bool isThorough();

}  // namespace locations
