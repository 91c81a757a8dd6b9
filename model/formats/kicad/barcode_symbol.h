#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace model::kicad {

enum class BarcodeKind : std::uint8_t { Qr, MicroQr, DataMatrix, Code39, Code128 };

/// "qr", "microqr", "datamatrix", "code39", "code128", as files of KiCad 10 name them; with _ between the words too.
[[nodiscard]] std::optional<BarcodeKind> barcodeKindNamed(std::string_view word);

/// A dark rectangle of a barcode, in modules, x to the right, y up.
struct BarcodeBar {
    double left = 0.0;
    double bottom = 0.0;
    double right = 0.0;
    double top = 0.0;
};

/// What of a barcode is dark: bars, or rows of modules that lie side by side, without the quiet zone around them.
/// `correction` is 1 to 4 for the levels L, M, Q and H of QR codes; 4 counts as 3 in a Micro QR code. The text is
/// UTF-8. Encoded by libzint, as KiCad does; which size and mask it takes may change with its version. Errors:
/// BadInput, with what libzint says of a text that the kind cannot hold.
[[nodiscard]] base::Result<std::vector<BarcodeBar>> barsOf(BarcodeKind kind, const std::string& text, int correction);

}  // namespace model::kicad
