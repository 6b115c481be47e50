"""The linear spring tends to the hard sphere: the shipped case, run by the shipped comparison.

A contact that lasts t_c turns its line of centres by v_t t_c / d, and t_c falls as K^(-1/2); so must every error."""
import os
import sys
import unittest

FOLDER = os.path.join(os.environ["SIMILITUDE_SOURCE"], "configs", "hard_sphere_limit")
sys.path.insert(0, FOLDER)
import compare  # noqa: E402

STIFFNESSES = (1e4, 1e5, 1e6, 1e7)   # [N/m]


class HardSphereLimit(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = compare.compare(os.environ["SIMILITUDE"], STIFFNESSES)

    def test_the_case_has_sticking_and_sliding_contacts(self):
        _, _, slides = compare.hard_sphere()
        self.assertEqual(list(slides), [False] * 6 + [True] * 4 + [False] * 2 + [True])

    def test_the_head_on_pair_keeps_its_restitution(self):
        for row in self.rows:
            self.assertAlmostEqual(row["restitution"], compare.RESTITUTION, delta=5e-4)   # linear in the step of t_c/1500

    def test_contact_times_and_errors_fall_as_the_root_of_the_stiffness(self):
        for name in ("contact_time", *compare.ERRORS):
            for order in compare.orders(self.rows, name):
                self.assertAlmostEqual(order, -0.5, delta=0.05, msg=name)

    def test_the_stiffest_spring_is_close_to_the_hard_sphere(self):
        stiffest = self.rows[-1]
        for name in ("sticking_angle", "sliding_angle", "wall_angle"):
            self.assertLess(stiffest[name], 0.2, name)   # [deg]
        for name in ("sticking_spin", "sliding_spin", "wall_spin"):
            self.assertLess(stiffest[name], 0.005, name)


if __name__ == "__main__":
    unittest.main()
