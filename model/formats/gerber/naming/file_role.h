#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/board/document.h"
#include "model/formats/gerber/image/image.h"

namespace model::gerber {

/// How it is known what a file draws, the best first. Told: by a layer map.
enum class RoleSource : std::uint8_t { Told, Attribute, JobFile, Comment, Name, Content, Unknown };

/// What a file of a Gerber job draws.
struct FileRole {
    enum class Kind : std::uint8_t {
        Unknown,
        Copper,
        SolderMask,
        Paste,
        Legend,
        Profile,
        Drill,
        Rout,
        Components,  ///< X3
        Glue,
        Document,  ///< drill maps, fabrication and assembly drawings, everything else
        Ignored    ///< left out, as a layer map says
    };
    Kind kind = Kind::Unknown;
    LayerSide side = LayerSide::None;
    int order = 0;  ///< copper: 1 is the top where the job counts so; 0 not said. Inner ones may count from 1 too
    bool isCountedFromTop = false;       ///< `order` counts all copper layers, not the inner ones only
    bool mayLeaveOutNumbers = false;     ///< `order` sorts inner copper, but its numbers need not follow each other
    bool isSideOnly = false;             ///< copper by a name that has no other word for it than a side: "board_top"
    bool isNegative = false;             ///< FilePolarity Negative of a copper layer
    Plating plating = Plating::NotSaid;  ///< drills
    int spanTop = 0;                     ///< drills: first and last copper layer, counted from the top; 0 not said
    int spanBottom = 0;
    RoleSource source = RoleSource::Unknown;

    [[nodiscard]] bool isKnown() const { return kind != Kind::Unknown; }
};

/// The value of a FileFunction attribute as Gerber files and as job files spell it: "Copper,L1,Top",
/// "Soldermask,Bot", "Plated,1,4,PTH". Nothing if it is no function of a layer of the board.
[[nodiscard]] std::optional<FileRole> roleOfFunction(std::string_view function);
/// From what CAD systems write into comments and names of layers and images.
[[nodiscard]] std::optional<FileRole> roleOfComments(const Image& image);
/// From a file's name without folders, by the table of common CAD systems.
[[nodiscard]] std::optional<FileRole> roleOfName(std::string_view name);
/// The last number in a name, without its ending: 3 of "GND03.art". 0 where there is none, or one of three digits.
[[nodiscard]] int numberInName(std::string_view name);
/// The name without what tells the role: files of one board have the same. "driver" of "driver.top.gbr".
[[nodiscard]] std::string boardOfName(std::string_view name);

/// For messages and names of layers: "top copper".
[[nodiscard]] std::string describe(const FileRole& role);

}  // namespace model::gerber
