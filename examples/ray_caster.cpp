// SPDX-License-Identifier: Apache-2.0
// A ray caster of somebody's own, with its own OpenCL, its own voxels and its own picture, that asks cdsm for the
// light: ray_caster [PICTURE.ppm]. Exit status 0 if the floor has a shadow.
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <cdsm/opencl.hpp>

namespace {

constexpr int kSize = 64, kWidth = 480, kHeight = 320;

const char* const kKernels = R"(
#define SIZE 64

float densityAt(__global const float* density, float3 p) {
  int3 at = clamp(convert_int3((p + 1.0f) * (SIZE / 2)), (int3)(0), (int3)(SIZE - 1));
  return all(fabs(p) < 1.0f) ? density[(at.z * SIZE + at.y) * SIZE + at.x] : 0.0f;
}

__kernel void cast(__global const float* density, uint lamp, __global float4* picture, CDSM_LOOKUP_PARAMS) {
  int x = get_global_id(0), y = get_global_id(1), width = get_global_size(0), height = get_global_size(1);
  float3 eye = (float3)(0.0f, 2.2f, 4.5f), color = (float3)(0.0f);
  float3 way = normalize((float3)(x - 0.5f * width, -0.2f * height - y, -1.5f * height));
  float toFloor = way.y < 0.0f ? -(eye.y + 1.0f) / way.y : INFINITY, clear = 1.0f, length = 0.01f;
  for (float t = 2.0f; t < min(toFloor, 7.0f) && clear > 0.001f; t += length) {
    float3 p = eye + t * way;
    float extinction = -log1p(-0.9f * densityAt(density, p)) / 0.2f;
    if (extinction <= 0.0f) continue;
    float seen = clear * (1.0f - exp(-extinction * length));
    color += seen * (0.05f + cdsmTransmittance(lamp, p, CDSM_LOOKUP_ARGS)) * (float3)(1.0f, 0.8f, 0.6f);
    clear -= seen;
  }
  float3 onFloor = eye + toFloor * way;
  if (toFloor < 12.0f) color += clear * (0.05f + 0.6f * cdsmTransmittance(lamp, onFloor, CDSM_LOOKUP_ARGS));
  picture[y * width + x] = (float4)(color, 1.0f);
}
)";

void check(cl_int code, const char* call) {
  if (code != CL_SUCCESS) throw std::runtime_error(std::string(call) + " failed with " + std::to_string(code));
}

/// Two puffs of smoke.
std::vector<float> smoke() {
  std::vector<float> values;
  for (int i = 0; i < kSize * kSize * kSize; ++i) {
    const glm::vec3 p = glm::vec3(i % kSize, i / kSize % kSize, i / kSize / kSize) / (kSize / 2.0f) - 1.0f;
    const float puff = std::max(0.8f - 1.6f * glm::distance(p, {-0.3f, -0.2f, 0.0f}),
                                0.7f - 2.2f * glm::distance(p, {0.45f, 0.4f, 0.1f}));
    values.push_back(
        std::max(0.0f, puff + 0.12f * std::sin(14.0f * p.x) * std::sin(13.0f * p.y) * std::sin(15.0f * p.z)));
  }
  return values;
}

cdsm::Scene smokeScene(cl_mem density) {
  cdsm::Scene scene;
  glm::mat4 objectFromIndex(2.0f / kSize);
  objectFromIndex[3] = glm::vec4(glm::vec3(1.0f / kSize - 1.0f), 1.0f);
  cdsm::Volume volume;
  volume.name = "smoke";
  volume.data = cdsm::opencl::volumeData(density, cdsm::VoxelType::Float32, glm::uvec3(kSize), objectFromIndex);
  volume.transfer.opacity = {{0.0f, 0.0f}, {1.0f, 0.9f}};
  volume.transfer.color = {{0.0f, glm::vec3(1.0f)}};
  volume.transfer.unitDistance = 0.2f;
  scene.volumes = {volume};
  scene.lights.resize(1);
  scene.lights[0].name = "lamp";
  scene.lights[0].position = {1.5f, 4.0f, -1.5f};
  scene.lights[0].cutoff = 60.0f;
  return scene;
}

cl_kernel makeKernel(const cdsm::opencl::Place& place, const cdsm::opencl::Lookup& lookup) {
  const char* texts[] = {lookup.source().c_str(), kKernels};
  cl_int code = CL_SUCCESS;
  cl_program program = clCreateProgramWithSource(place.context, 2, texts, nullptr, &code);
  check(code, "clCreateProgramWithSource");
  check(clBuildProgram(program, 1, &place.device, lookup.buildOptions().c_str(), nullptr, nullptr), "clBuildProgram");
  cl_kernel kernel = clCreateKernel(program, "cast", &code);
  check(code, "clCreateKernel");
  clReleaseProgram(program);
  return kernel;
}

void drawWithShadows(cdsm::Engine& engine, cl_mem density, cl_mem picture) {
  const cdsm::opencl::Place place = cdsm::opencl::placeOf(engine);
  engine.prepare(smokeScene(density));
  const cdsm::opencl::Lookup lookup = cdsm::opencl::lookup(engine);
  cl_kernel kernel = makeKernel(place, lookup);
  const cl_uint lamp = lookup.light("lamp");
  check(clSetKernelArg(kernel, 0, sizeof density, &density), "clSetKernelArg");
  check(clSetKernelArg(kernel, 1, sizeof lamp, &lamp), "clSetKernelArg");
  check(clSetKernelArg(kernel, 2, sizeof picture, &picture), "clSetKernelArg");
  lookup.setArguments(kernel, 3);
  const std::size_t items[] = {kWidth, kHeight}, group[] = {8, 8};
  check(clEnqueueNDRangeKernel(place.queue, kernel, 2, nullptr, items, group, 0, nullptr, nullptr), "cast");
  check(clFinish(place.queue), "clFinish");
  clReleaseKernel(kernel);
}

void save(const char* path, const std::vector<glm::vec4>& pixels) {
  std::FILE* file = std::fopen(path, "wb");
  if (!file) throw std::runtime_error(std::string(path) + ": cannot be written");
  std::fprintf(file, "P6 %d %d 255\n", kWidth, kHeight);
  for (const glm::vec4& pixel : pixels)
    for (int channel = 0; channel < 3; ++channel)
      std::fputc(int(255.0f * std::pow(std::min(pixel[channel], 1.0f), 1.0f / 2.2f) + 0.5f), file);
  std::fclose(file);
}

/// The brightest pixel of the lowest rows by the darkest one: all of them are floor.
float contrastOfTheFloor(const std::vector<glm::vec4>& pixels) {
  float least = INFINITY, most = 0.0f;
  for (std::size_t i = std::size_t(kWidth) * kHeight * 4 / 5; i < pixels.size(); ++i) {
    least = std::min(least, pixels[i].x);
    most = std::max(most, pixels[i].x);
  }
  return most / least;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    // any context and queue would do; this program borrows the engine's
    cdsm::Engine engine;
    const cdsm::opencl::Place place = cdsm::opencl::placeOf(engine);
    std::vector<float> voxels = smoke();
    std::vector<glm::vec4> pixels(std::size_t(kWidth) * kHeight);
    cl_int code = CL_SUCCESS;
    cl_mem density = clCreateBuffer(place.context, CL_MEM_COPY_HOST_PTR, 4 * voxels.size(), voxels.data(), &code);
    check(code, "clCreateBuffer");
    cl_mem picture = clCreateBuffer(place.context, CL_MEM_READ_WRITE, 16 * pixels.size(), nullptr, &code);
    check(code, "clCreateBuffer");
    drawWithShadows(engine, density, picture);
    check(clEnqueueReadBuffer(place.queue, picture, CL_TRUE, 0, 16 * pixels.size(), pixels.data(), 0, nullptr, nullptr),
          "clEnqueueReadBuffer");
    clReleaseMemObject(density);
    clReleaseMemObject(picture);
    if (count > 1) save(arguments[1], pixels);
    const float contrast = contrastOfTheFloor(pixels);
    std::printf("the floor is %.1f times as bright in the light as in the shadow\n", contrast);
    return contrast > 2.0f ? 0 : 1;
  } catch (const std::exception& error) {
    std::printf("error: %s\n", error.what());
    return 1;
  }
}
