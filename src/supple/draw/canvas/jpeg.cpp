#include "supple/draw/canvas/jpeg.hpp"

#include <cstdio>  // jpeglib.h needs it

#include <jpeglib.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "supple/core/error.hpp"

namespace supple {

namespace {

[[noreturn]] void fail_jpeg(j_common_ptr info) {
  char reason[JMSG_LENGTH_MAX];
  info->err->format_message(info, reason);
  throw file_error("cannot encode the picture as JPEG", reason);
}

}  // namespace

std::string encode_jpeg(const PixelRows& pixels) {
  jpeg_compress_struct job{};
  jpeg_error_mgr errors;
  job.err = jpeg_std_error(&errors);
  errors.error_exit = fail_jpeg;
  struct Output {
    unsigned char* data = nullptr;
    unsigned long size = 0;
    ~Output() { std::free(data); }
  } out;
  struct Release {
    jpeg_compress_struct& job;
    ~Release() { jpeg_destroy_compress(&job); }
  } release{job};

  jpeg_create_compress(&job);
  jpeg_mem_dest(&job, &out.data, &out.size);
  job.image_width = static_cast<JDIMENSION>(pixels.width);
  job.image_height = static_cast<JDIMENSION>(pixels.height);
  job.input_components = 3;
  job.in_color_space = JCS_RGB;
  jpeg_set_defaults(&job);
  jpeg_set_quality(&job, 92, TRUE);
  jpeg_start_compress(&job, TRUE);

  std::vector<JSAMPLE> row(3 * pixels.width);
  while (job.next_scanline < job.image_height) {
    const std::uint32_t* line = pixels.first + job.next_scanline * pixels.stride;
    for (std::size_t x = 0; x < pixels.width; ++x)
      for (const int channel : {0, 1, 2}) row[3 * x + channel] = line[x] >> (16 - 8 * channel) & 0xff;
    JSAMPROW rows[] = {row.data()};
    jpeg_write_scanlines(&job, rows, 1);
  }
  jpeg_finish_compress(&job);
  return {reinterpret_cast<const char*>(out.data), out.size};
}

}  // namespace supple
