// SPDX-License-Identifier: MIT
// Two decomposers of Bullet's extras as programs of ./dev field:
// decomposers hacd|hacd-full|ratcliff INPUT.obj OUTPUT.obj
// Writes an object for each part, and the seconds of the library's own call to OUTPUT.obj.json.
#include <ConvexDecomposition/ConvexBuilder.h>
#include <HACD/hacdHACD.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Mesh {
  std::vector<double> coordinates;
  std::vector<long> corners;
};

// Seconds since it was made, of the processor if they are less than those of the clock.
class Stopwatch {
 public:
  double seconds() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return std::min(passed.count(), double(std::clock() - used_) / CLOCKS_PER_SEC);
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t used_ = std::clock();
};

Mesh read_mesh(const char* path) {
  Mesh mesh;
  std::ifstream in(path);
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    if (!(words >> word)) continue;
    if (word == "v") {
      for (double x; words >> x;) mesh.coordinates.push_back(x);
    } else if (word == "f") {
      std::vector<long> face;
      while (words >> word) face.push_back(std::stol(word) - 1);
      for (std::size_t k = 2; k < face.size(); ++k) {
        mesh.corners.insert(mesh.corners.end(), {face[0], face[k - 1], face[k]});
      }
    }
  }
  return mesh;
}

class Writer {
 public:
  explicit Writer(const std::string& path) : out_(path), path_(path) {}

  void begin_part(int digits) {
    char name[32];
    std::snprintf(name, sizeof name, "o part_%03d\n", parts_++);
    out_.precision(digits);
    out_ << name;
    first_ += points_;
    points_ = 0;
  }
  void point(double x, double y, double z) {
    out_ << "v " << x << ' ' << y << ' ' << z << '\n';
    ++points_;
  }
  void face(long a, long b, long c) {
    out_ << "f " << first_ + a + 1 << ' ' << first_ + b + 1 << ' ' << first_ + c + 1 << '\n';
  }
  void seconds(double seconds) {
    std::ofstream(path_ + ".json") << "{\"seconds\": " << seconds << "}\n";
  }
  int parts() const { return parts_; }

 private:
  std::ofstream out_;
  std::string path_;
  int parts_ = 0;
  long first_ = 0, points_ = 0;
};

// The library scales its input so that the diagonal of the box is 2,000: 60 is 3%. The weights are
// those of Bullet's own example; hulls have the default number of vertices, or all.
void run_hacd(const Mesh& mesh, bool all_vertices, Writer& writer) {
  std::vector<HACD::Vec3<HACD::Real>> points;
  for (std::size_t k = 0; k + 2 < mesh.coordinates.size(); k += 3) {
    points.emplace_back(mesh.coordinates[k], mesh.coordinates[k + 1], mesh.coordinates[k + 2]);
  }
  std::vector<HACD::Vec3<long>> triangles;
  for (std::size_t k = 0; k + 2 < mesh.corners.size(); k += 3) {
    triangles.emplace_back(mesh.corners[k], mesh.corners[k + 1], mesh.corners[k + 2]);
  }
  HACD::HACD hacd;
  hacd.SetPoints(points.data());
  hacd.SetNPoints(points.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  hacd.SetNClusters(1);
  hacd.SetConcavity(60);
  hacd.SetCompacityWeight(0.1);
  hacd.SetVolumeWeight(0);
  const Stopwatch watch;
  if (!hacd.Compute(all_vertices)) return;
  writer.seconds(watch.seconds());
  for (std::size_t part = 0; part < hacd.GetNClusters(); ++part) {
    std::vector<HACD::Vec3<HACD::Real>> corners(hacd.GetNPointsCH(part));
    std::vector<HACD::Vec3<long>> faces(hacd.GetNTrianglesCH(part));
    hacd.GetCH(part, corners.data(), faces.data());
    writer.begin_part(17);
    // Points that no face uses are left out, as by all adapters: they would count as the part's.
    std::map<long, long> index;
    for (const auto& face : faces) {
      for (const long k : {face.X(), face.Y(), face.Z()}) {
        if (!index.emplace(k, index.size()).second) continue;
        writer.point(corners[k].X(), corners[k].Y(), corners[k].Z());
      }
    }
    for (const auto& face : faces) writer.face(index[face.X()], index[face.Y()], index[face.Z()]);
  }
}

struct Results : ConvexDecomposition::ConvexDecompInterface {
  explicit Results(Writer& to) : writer(to) {}
  void ConvexDecompResult(ConvexDecomposition::ConvexResult& result) override {
    writer.begin_part(9);
    const float* x = result.mHullVertices;
    for (unsigned k = 0; k < result.mHullVcount; ++k, x += 3) writer.point(x[0], x[1], x[2]);
    const unsigned* corner = result.mHullIndices;
    for (unsigned k = 0; k < result.mHullTcount; ++k, corner += 3) {
      writer.face(corner[0], corner[1], corner[2]);
    }
  }
  Writer& writer;
};

// With the defaults of DecompDesc: depth 5, concavity 5%, merged below 5%, 32 vertices.
void run_ratcliff(const Mesh& mesh, Writer& writer) {
  const std::vector<float> points(mesh.coordinates.begin(), mesh.coordinates.end());
  std::vector<unsigned> corners(mesh.corners.begin(), mesh.corners.end());
  Results results(writer);
  ConvexDecomposition::DecompDesc description;
  description.mVcount = unsigned(points.size() / 3);
  description.mVertices = points.data();
  description.mTcount = unsigned(corners.size() / 3);
  description.mIndices = corners.data();
  description.mCallback = &results;
  ConvexBuilder builder(&results);
  const Stopwatch watch;
  builder.process(description);
  writer.seconds(watch.seconds());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const std::string mode = arguments[1];
  const Mesh mesh = read_mesh(arguments[2]);
  if (mesh.corners.empty()) return 4;
  Writer writer(arguments[3]);
  if (mode == "ratcliff") {
    run_ratcliff(mesh, writer);
  } else {
    run_hacd(mesh, mode == "hacd-full", writer);
  }
  return writer.parts() > 0 ? 0 : 4;
}
