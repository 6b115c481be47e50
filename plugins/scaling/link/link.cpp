#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Link et al. (2009): the real bed with larger, lighter particles in a more viscous gas. The member of the similarity family
/// with r = 1 and the gas density kept: mu* = n, (rho_p - rho_f)* = 1/n.
struct Link {
  double n;   // [-]

  static void parameters(Parameters<Link>& p) {
    p.real("n", &Link::n,
           {.min = 1, .max = 100, .typical_min = 1, .typical_max = 4, .doc = "Simulated over real particle diameter."});
  }

  Ratios ratios(const Bed& real) const {
    require_heavy_particles(real, "link");
    return similar_bed(real, 1, n, 1);
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Link, "link", "1.0.0", "Larger, lighter particles in a more viscous gas", "Similitude authors",
                       "Link, Godlieb, Tripp, Deen, Heinrich, Kuipers, Schoenherr & Peglow (2009), Powder Technol. 189, 202")
