#include "model/formats/kicad/barcode_symbol.h"

#include <zint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace model::kicad {

namespace {

constexpr int kUtf8 = 26;  ///< the extended channel that says so

using Symbol = std::unique_ptr<zint_symbol, decltype(&ZBarcode_Delete)>;

int symbologyOf(BarcodeKind kind) {
    switch (kind) {
        case BarcodeKind::Qr: return BARCODE_QRCODE;
        case BarcodeKind::MicroQr: return BARCODE_MICROQR;
        case BarcodeKind::DataMatrix: return BARCODE_DATAMATRIX;
        case BarcodeKind::Code39: return BARCODE_CODE39;
        case BarcodeKind::Code128: return BARCODE_CODE128;
    }
    return BARCODE_QRCODE;
}

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

void configure(zint_symbol& symbol, BarcodeKind kind, const std::string& text, int correction) {
    symbol.symbology = symbologyOf(kind);
    symbol.input_mode = UNICODE_MODE;
    symbol.show_hrt = 0;  // the text below is KiCad's own
    if (kind == BarcodeKind::Qr || kind == BarcodeKind::MicroQr) {
        symbol.option_1 = kind == BarcodeKind::MicroQr ? std::min(correction, 3) : correction;
    }
    if ((kind == BarcodeKind::Qr || kind == BarcodeKind::DataMatrix) && !isAscii(text)) {
        symbol.eci = kUtf8;
    }
}

/// Edges are rounded one by one, so that neighbours share them.
BarcodeBar barOf(const zint_vector_rect& bar) {
    return {std::round(bar.x), -std::round(bar.y + bar.height), std::round(bar.x + bar.width), -std::round(bar.y)};
}

}  // namespace

std::optional<BarcodeKind> barcodeKindNamed(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, BarcodeKind>, 5> kKinds = {
        {{"qr", BarcodeKind::Qr},
         {"microqr", BarcodeKind::MicroQr},
         {"datamatrix", BarcodeKind::DataMatrix},
         {"code39", BarcodeKind::Code39},
         {"code128", BarcodeKind::Code128}}};
    std::string plain(word);
    std::erase(plain, '_');
    const auto* const found = std::ranges::find(kKinds, plain, [](const auto& kind) { return kind.first; });
    return found == kKinds.end() ? std::nullopt : std::optional(found->second);
}

base::Result<std::vector<BarcodeBar>> barsOf(BarcodeKind kind, const std::string& text, int correction) {
    const Symbol symbol(ZBarcode_Create(), &ZBarcode_Delete);
    if (symbol == nullptr) {
        return base::Error{base::ErrorCode::BadInput, "there is no memory for it"};
    }
    configure(*symbol, kind, text, correction);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
    if (ZBarcode_Encode(symbol.get(), bytes, static_cast<int>(text.size())) >= ZINT_ERROR ||
        ZBarcode_Buffer_Vector(symbol.get(), 0) >= ZINT_ERROR) {
        return base::Error{base::ErrorCode::BadInput, symbol->errtxt};
    }
    std::vector<BarcodeBar> bars;
    for (const zint_vector_rect* bar = symbol->vector->rectangles; bar != nullptr; bar = bar->next) {
        bars.push_back(barOf(*bar));
    }
    return bars;
}

}  // namespace model::kicad
