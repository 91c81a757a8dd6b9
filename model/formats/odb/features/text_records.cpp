#include "model/formats/odb/features/text_records.h"

#include <cmath>

namespace model::odb {

Orientation readOrientation(Fields& fields) {
    if (fields.atEnd()) {
        return {};  // old writers leave it away
    }
    const std::int32_t code = fields.integer();
    if (code == 8 || code == 9) {
        return {fields.real(), code == 9};
    }
    return {static_cast<double>(code & 3) * 90.0, (code & 4) != 0};
}

TextRecord readText(Fields& fields, std::int64_t nmPerUnit, std::string_view font) {
    TextRecord record;
    record.font = toUtf8(font);
    record.line.xSize = fields.length(nmPerUnit);
    record.line.ySize = fields.length(nmPerUnit);
    record.line.widthFactor = fields.real();
    record.line.text = toUtf8(fields.quoted());
    return record;
}

BarcodeRecord readBarcode(Fields& fields, std::int64_t nmPerUnit, std::string_view code, std::string_view font) {
    const auto flag = [&fields] {
        const std::string_view letter = fields.word();
        return letter == "Y" || letter == "y";
    };
    BarcodeRecord record;
    record.code = toUtf8(code);
    record.font = toUtf8(font);
    fields.word();  // E, a constant
    record.elementWidth = fields.length(nmPerUnit);
    record.height = fields.length(nmPerUnit);
    record.isFullAscii = flag();
    record.hasChecksum = flag();
    record.isInverted = flag();
    record.hasString = flag();
    const std::string_view location = fields.word();
    record.isStringAbove = location == "T" || location == "t";
    record.text = toUtf8(fields.quoted());
    return record;
}

}  // namespace model::odb
