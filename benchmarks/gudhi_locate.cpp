// GUDHI's point location, timed, or its simplices for a test.
//
//     gudhi_locate time DIMENSION POINTS FILE     seconds of the processor, once, for all points of the file
//     gudhi_locate vertices DIMENSION POINTS FILE the vertices of the simplex of each point, as float64
//
// The file has POINTS times DIMENSION numbers, float64. Simplices are kept as GUDHI returns them.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <gudhi/Coxeter_triangulation.h>

using Triangulation = Gudhi::coxeter_triangulation::Coxeter_triangulation<>;

int main(int count, char** words) {
  if (count != 5) return EXIT_FAILURE;
  const std::size_t d = std::stoul(words[2]), n = std::stoul(words[3]);
  std::vector<double> numbers(n * d);
  std::ifstream file(words[4], std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(numbers.data()), numbers.size() * sizeof(double))) return EXIT_FAILURE;
  const Triangulation triangulation(d);
  std::vector<double> point(d);
  if (std::string(words[1]) == "time") {
    std::size_t used = 0;  // looked at, so that nothing is left out
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < n; ++i) {
      point.assign(numbers.begin() + i * d, numbers.begin() + (i + 1) * d);
      used += triangulation.locate_point(point).vertex()[0];
    }
    const double taken = double(std::clock() - begin) / CLOCKS_PER_SEC;
    std::cout.precision(9);
    std::cout << taken << ' ' << used << '\n';
    return EXIT_SUCCESS;
  }
  for (std::size_t i = 0; i < n; ++i) {
    point.assign(numbers.begin() + i * d, numbers.begin() + (i + 1) * d);
    const auto simplex = triangulation.locate_point(point);
    if (simplex.dimension() != d) return 2;
    for (const auto& vertex : simplex.vertex_range()) {
      const Eigen::VectorXd x = triangulation.cartesian_coordinates(vertex);
      std::fwrite(x.data(), sizeof(double), d, stdout);
    }
  }
  return EXIT_SUCCESS;
}
