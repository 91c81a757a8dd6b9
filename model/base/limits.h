#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// How much of anything the files of a board may ask for, in one place for all readers. Archives in archives, symbols
/// in symbols and steps in steps multiply: without a bound a file of a few bytes takes all time and memory there is.
/// The largest boards that we know stay far below (docs/limits.md has the table). What lies beyond is an error or a
/// message that names the limit, and the option where there is one; the rest of the board is shown.
namespace base {

// ---- what is unpacked ----

inline constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
inline constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

/// Bytes that an archive may unpack to; another number is set by --max-unpacked.
inline constexpr std::uint64_t kMostUnpackedBytes = 4 * kGiB;
/// Bytes that one packed file of a job may unpack to.
inline constexpr std::uint64_t kMostMemberBytes = 512 * kMiB;
/// How many times its packed size an archive may unpack to, once it is beyond kFreelyUnpackedBytes: text of a board
/// packs to a tenth or a twentieth, what was made to burst to a thousandth.
inline constexpr std::uint64_t kMostExpansion = 250;
inline constexpr std::uint64_t kFreelyUnpackedBytes = 64 * kMiB;
/// Files in an archive or folder.
inline constexpr std::size_t kMostEntries = 1'000'000;
/// Archives in an archive or folder that are looked into; archives in those are not.
inline constexpr std::size_t kMostInnerArchives = 24;
/// Bytes of one file that is read as it is, packed or not.
inline constexpr std::uint64_t kMostFileBytes = kGiB;
/// Bytes of a file of settings: a session, rules, waivers, a layer map, a project of KiCad.
inline constexpr std::uint64_t kMostSettingBytes = 16 * kMiB;

// ---- what holds itself ----

inline constexpr std::size_t kMostXmlDepth = 64;    ///< elements of XML; those of IPC-2581 nest 15 deep
inline constexpr std::size_t kMostListDepth = 64;   ///< lists of S-expressions (custom rules of KiCad)
inline constexpr std::size_t kMostJsonDepth = 64;   ///< values of JSON
inline constexpr int kMostShapeDepth = 8;           ///< shapes in shapes, by nesting or by name (IPC-2581)
inline constexpr std::size_t kMostBlockDepth = 50;  ///< blocks and repeated steps of Gerber images
inline constexpr int kMostStepDepth = 8;            ///< steps in steps; panels nest two or three deep

// ---- what multiplies ----

inline constexpr std::size_t kMostCopies = 100'000;       ///< of steps on a panel, at whatever depth
inline constexpr std::size_t kMostLayers = 5'000;         ///< rows of a matrix
inline constexpr std::size_t kMostExpanded = 4'000'000;   ///< objects by blocks and repeated steps of a Gerber image
inline constexpr std::size_t kMostRepeated = 100'000;     ///< holes by repetitions of a drill file
inline constexpr std::size_t kMostReferred = 10'000'000;  ///< shapes by references to user shapes (IPC-2581)
inline constexpr std::size_t kMostCorners = 2'000'000;    ///< of one contour

/// For messages: "more than 100000 copies, the limit".
[[nodiscard]] inline std::string moreThan(std::uint64_t limit, std::string_view what) {
    return "more than " + std::to_string(limit) + " " + std::string(what) + ", the limit";
}

}  // namespace base
