#include "render/frame/png.h"

#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <exception>

namespace render {
namespace {

/// libpng leaves what it calls by a jump, so nothing that is called from there may throw or have a destructor.
class Packing {
public:
    Packing(const PngRows& rows, const std::function<bool(std::string_view)>& write)
        : m_rows(rows),
          m_write(write),
          m_png(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, &Packing::fail, &Packing::ignore)),
          m_info(m_png != nullptr ? png_create_info_struct(m_png) : nullptr) {}
    ~Packing() { png_destroy_write_struct(&m_png, &m_info); }
    Packing(const Packing&) = delete;
    Packing& operator=(const Packing&) = delete;

    base::Status run() {
        const bool isPacked = m_info != nullptr && pack();
        if (m_thrown) {
            std::rethrow_exception(m_thrown);
        }
        if (!m_goesOn) {
            return base::Error{base::ErrorCode::Cancelled, "The picture is no longer wanted."};
        }
        return isPacked ? base::Status(base::Done{})
                        : base::Error{base::ErrorCode::OutputFailed, std::string("Cannot make a picture: ") + m_why};
    }

private:
    bool pack() {
        if (setjmp(png_jmpbuf(m_png)) != 0) {
            return false;
        }
        begin();
        packRows();
        return true;
    }

    void begin() {
        png_set_write_fn(m_png, this, &Packing::take, &Packing::flush);
        png_set_IHDR(m_png, m_info, m_rows.width, m_rows.height, 8,
                     m_rows.hasAlpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        // Boards are plain colours and edges: without filters a picture is packed in a third of the time, as small.
        // libpng takes 0, PNG_NO_FILTERS, for a wish for all of them.
        png_set_filter(m_png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
        png_set_compression_level(m_png, 3);
        png_write_info(m_png, m_info);
    }

    void packRows() {
        for (std::uint32_t row = 0; row < m_rows.height && m_goesOn; ++row) {
            png_write_row(m_png, m_rows.row(row));
        }
        if (m_goesOn) {
            png_write_end(m_png, nullptr);
        }
    }

    static void take(png_structp png, png_bytep bytes, std::size_t size) {
        static_cast<Packing*>(png_get_io_ptr(png))->give({reinterpret_cast<const char*>(bytes), size});
    }

    void give(std::string_view piece) noexcept {
        try {
            m_goesOn = m_goesOn && m_write(piece);
        } catch (...) {
            m_goesOn = false;
            m_thrown = std::current_exception();
        }
    }

    static void flush(png_structp) {}
    static void ignore(png_structp, png_const_charp) {}
    [[noreturn]] static void fail(png_structp png, png_const_charp why) {
        auto& packing = *static_cast<Packing*>(png_get_error_ptr(png));
        std::snprintf(packing.m_why, sizeof(packing.m_why), "%s", why);
        png_longjmp(png, 1);
    }

    const PngRows& m_rows;
    const std::function<bool(std::string_view)>& m_write;
    char m_why[128] = "there is not enough memory";
    std::exception_ptr m_thrown;
    bool m_goesOn = true;
    png_structp m_png;
    png_infop m_info;
};

}  // namespace

base::Status packPng(const PngRows& rows, const std::function<bool(std::string_view)>& write) {
    return Packing(rows, write).run();
}

base::Result<std::string> encodePng(const Image& image) {
    ASSERT(image.rgba.size() == std::size_t{image.width} * image.height * 4);
    const auto rowOf = [&](std::uint32_t row) { return image.rgba.data() + std::size_t{row} * image.width * 4; };
    std::string png;
    RETURN_IF_ERROR(packPng({image.width, image.height, true, rowOf}, [&](std::string_view piece) {
        png += piece;
        return true;
    }));
    return png;
}

}  // namespace render
