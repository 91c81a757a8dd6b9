#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "model/formats/gerber/image/image.h"

namespace model::gerber {

/// A text of the job as UTF-8: `\uXXXX` and `\UXXXXXXXX` resolved, bytes that are no UTF-8 taken as Latin-1.
[[nodiscard]] std::string unescaped(std::string_view text);

/// The attributes that hold at a point of the file: the dictionaries of apertures (TA) and objects (TO), and what
/// follows from them for the objects drawn there.
class AttributeState {
public:
    explicit AttributeState(Image& image) : m_image(image) {}

    /// A command TF, TA, TO, TD or TJ with what follows it: ".N,GND". False if it is none of these.
    bool command(std::string_view code, std::string_view rest);

    /// The dictionary of apertures now; an aperture keeps the one that held when it was defined.
    [[nodiscard]] std::int32_t apertureSet();
    /// Gives an object its net, pin, kind and attributes. `apertureSet` is that of its aperture, or of a region the one
    /// that holds now.
    void apply(formats::DrawnFeature& feature, std::int32_t apertureSet);

private:
    void set(formats::Words& words, std::string_view rest);
    void remove(std::string_view name);
    void refreshObject();
    void look(std::int32_t apertureSet);
    [[nodiscard]] std::int32_t netRow(std::string_view value);
    [[nodiscard]] std::int32_t componentRow(const std::string& refdes);
    [[nodiscard]] std::int32_t pinRow(std::string_view value);

    Image& m_image;
    formats::Words m_aperture;
    formats::Words m_object;
    std::vector<formats::Words> m_apertureSets;
    std::int32_t m_apertureSet = formats::kNoRow;
    bool m_isApertureOld = false;
    bool m_isObjectOld = false;
    formats::DrawnFeature m_now;  ///< net, component and pin of the dictionary of objects
    formats::Words m_otherWords;  ///< the object attributes without a meaning of their own
    bool m_hasLast = false;       ///< what the last look found
    std::int32_t m_lastSet = formats::kNoRow;
    std::int32_t m_lastRow = formats::kNoRow;
    SubnetKind m_lastKind = SubnetKind::Other;
    std::unordered_map<std::int32_t, std::int32_t> m_setRows;  ///< by aperture set, for the objects' words of now
    std::unordered_map<std::string, std::int32_t> m_nets;
    std::unordered_map<std::string, std::int32_t> m_components;
    std::unordered_map<std::string, std::int32_t> m_pins;
    std::unordered_map<std::string, std::int32_t> m_wordRows;
};

}  // namespace model::gerber
