"""The commands of `attitude`: against the worked rotations, from files and from flags."""

import math

from attitude_support import about, AttitudeTest, cross, matrix_of, product, transposed
from face_support import ROOT, load, run


class Convert(AttitudeTest):
    def test_agrees_with_the_worked_rotations(self):
        rows = load(ROOT / "data/attitude/table.json")["rows"]
        self.assertGreater(len(rows), 100)
        for row in rows:
            with self.subTest(row["name"]):
                found = self.convert({"quaternion": row["q_in"]})
                self.assert_close(found["matrix"], row["R"], 1e-15)
                self.assert_close(found["quaternion"], row["q"], 1e-15)
                self.assert_close(found["mrp"], row["mrp"], 1e-15)
                self.assertAlmostEqual(math.radians(found["angle_deg"]), row["angle"], delta=2e-15)
                if row["rodrigues"]:
                    self.assert_close(found["rodrigues"], row["rodrigues"], 1e-14 * (1 + max(map(abs, row["rodrigues"]))) ** 2)
                for sequence, angles in found["euler_deg"].items():
                    self.assert_close(matrix_of(sequence, angles), row["R"], 2e-15)
                    if row["euler_intrinsic"][sequence]["locked"]:
                        self.assertTrue(found["locked"][sequence], sequence)
                    elif found["locked"][sequence]:  # of turns by 1e-20 the table knows more than doubles can
                        self.assertLess(found["lock_distance"][sequence], 1e-15)
                    middle = row["euler_intrinsic"][sequence]["angles"][1]
                    self.assertAlmostEqual(math.radians(angles[1]), middle, delta=2e-15 / max(found["lock_distance"][sequence], 1e-8))

    def test_every_form_says_the_same(self):
        found = self.convert({"axis": [1, 2, 2], "angle_deg": 75})
        sequence = "yxz"
        forms = [{"matrix": found["matrix"]}, {"quaternion": [3 * x for x in found["quaternion"]]},
                 {"rotation_vector": found["rotation_vector"]}, {"rodrigues": found["rodrigues"]}, {"mrp": found["mrp"]},
                 {"euler_deg": found["euler_deg"][sequence], "sequence": sequence},
                 {"euler_deg": found["euler_deg"][sequence], "sequence": "2-1-3"},
                 {"euler_deg": found["euler_deg"][sequence][::-1], "sequence": sequence[::-1], "turning": "extrinsic"},
                 {"turns": [{"axis": [1, 2, 2], "angle_deg": 25}, {"axis": [1, 2, 2], "angle_deg": 50}]},
                 {"triads": {"fixed": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "moving": transposed(found["matrix"])}}]
        for form in forms:
            with self.subTest(form):
                self.assert_close(self.convert(form)["quaternion"], found["quaternion"], 1e-15)

    def test_flags_say_what_files_say(self):
        def text(values):
            return ",".join(map(str, values))

        for flags, orientation in (
            (("--axis", "0,0,1", "--angle", "30"), {"axis": [0, 0, 1], "angle_deg": 30}),
            (("--axis", "-1,.5,-2e-1", "--angle", "-30"), {"axis": [-1, 0.5, -0.2], "angle_deg": -30}),
            (("--euler", "zxz", "30,40,50"), {"euler_deg": [30, 40, 50], "sequence": "zxz"}),
            (("--euler", "xyz", "-30,-40,50", "--extrinsic"), {"euler_deg": [-30, -40, 50], "sequence": "xyz", "turning": "extrinsic"}),
            (("--quaternion", "-1 2 3 4"), {"quaternion": [-1, 2, 3, 4]}),
            (("--matrix", "0,-1,0; 1,0,0; 0,0,1"), {"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}),
            (("--matrix", text([2, 0, 0, 0, 1, 0, 0, 0, 1]), "--nearest"), {"matrix": [[2, 0, 0], [0, 1, 0], [0, 0, 1]], "nearest": True}),
            (("--rotation-vector", "0.1,0.2,0.3"), {"rotation_vector": [0.1, 0.2, 0.3]}),
            (("--rodrigues", "0.1,0.2,0.3"), {"rodrigues": [0.1, 0.2, 0.3]}),
            (("--mrp", "0.1,0.2,0.3"), {"mrp": [0.1, 0.2, 0.3]}),
        ):
            with self.subTest(flags):
                self.assertEqual(self.flags("convert", *flags), self.convert(orientation))
        self.assertEqual(self.flags("convert", "--mrp", "0,0,0.1", "--vector", "1,0,0", "--vector", "0,-1,0"),
                         self.convert({"mrp": [0, 0, 0.1]}, vectors=[[1, 0, 0], [0, -1, 0]]))

    def test_the_axis_of_no_turn_is_undefined(self):
        found = self.convert({"rotation_vector": [0, 0, 0]})
        self.assertEqual((found["axis_defined"], found["angle_deg"], found["rodrigues"]), (False, 0, [0, 0, 0]))
        self.assertIn("No rotation", run("attitude", "convert", "--rotation-vector", "0,0,0")[1])

    def test_a_half_turn_has_no_rodrigues_vector(self):
        found = self.convert({"quaternion": [0, -1, 0, 0]})
        self.assertIsNone(found["rodrigues"])
        self.assertEqual((found["axis"], found["angle_deg"]), ([1, 0, 0], 180))
        self.assertIn("half-turn", run("attitude", "convert", "--quaternion", "0,1,0,0")[1])

    def test_a_locked_sequence_says_so(self):
        output = run("attitude", "convert", "--euler", "xyz", "30,90,40")[1].replace("\n", " ")
        self.assertIn("Gimbal lock of xyz: the first and the third axis coincide, so that only first + third = 70.0000°", output)
        found = self.convert({"euler_deg": [30, -90, 40], "sequence": "xyz"})
        self.assertTrue(found["locked"]["xyz"])
        self.assertEqual(found["determined"]["xyz"]["combination"], "first - third")
        self.assertAlmostEqual(found["determined"]["xyz"]["angle_deg"], -10, delta=1e-12)
        near = run("attitude", "convert", "--euler", "zxz", "30,0.000001,40")[1].replace("\n", " ")
        self.assertIn("Near gimbal lock of zxz", near)
        self.assertIn("first + third = 70.0000° is not", near)

    def test_tensor_properties_images_and_resals_frame(self):
        found = self.convert({"euler_deg": [20, 50, 70], "sequence": "zxz"}, vectors=[[1, 2, 3], [0, 0, 0]])
        matrix = found["matrix"]
        tensor = [[sum(a[i] * b[j] for a, b in found["dyads"]) for j in range(3)] for i in range(3)]
        self.assert_close(tensor, matrix)
        self.assert_close([[found["matrix_minus_identity"][i][j] + (i == j) for j in range(3)] for i in range(3)], matrix)
        self.assert_close(found["images"], [[row[0] for row in product(matrix, [[1], [2], [3]])], [0, 0, 0]])
        self.assert_close(found["resal"]["matrix"], matrix_of("zx", [20, 50]))
        self.assertAlmostEqual(found["resal"]["spin_deg"], 70, delta=1e-12)
        properties = found["properties"]
        self.assertLess(properties["orthogonality_error"] + properties["cofactor_error"] + abs(properties["determinant"] - 1), 4e-15)
        self.assert_close(properties["eigenvalue_one"]["axis"], found["axis"])

    def test_the_nearest_rotation_on_request(self):
        noisy = [[1.1, 0, 0], [0, 1, 0.2], [0, 0, 1]]
        found = self.convert({"matrix": noisy, "nearest": True})
        self.assertGreater(found["nearest_distance"], 0.1)
        self.assertLess(found["properties"]["orthogonality_error"], 4e-15)
        self.assertIn("nearest rotation", run("attitude", "convert", "--nearest", "--matrix", "1.1,0,0,0,1,0.2,0,0,1")[1])


class Screw(AttitudeTest):
    def test_there_and_back(self):
        given = {"axis": [1, 2, 6], "point": [60, -20, 0], "angle_deg": 120, "slide": 50}
        found = self.report("screw", {"length_unit": "mm", "displacement": {"screw": given}, "points": [[60, -20, 0]], "directions": [[1, 2, 6]]})
        self.assertEqual(found["screw"]["kind"], "general")
        self.assertAlmostEqual(found["screw"]["angle_deg"], 120, delta=1e-12)
        self.assertAlmostEqual(found["screw"]["slide"], 50, delta=1e-12)
        self.assertAlmostEqual(found["screw"]["pitch"], 50 / math.radians(120), delta=1e-12)
        self.assert_close(cross([a - b for a, b in zip(found["screw"]["point"], given["point"])], given["axis"]), [0, 0, 0], 1e-12)
        unit = [x / math.sqrt(41) for x in given["axis"]]
        self.assert_close(found["displaced_points"][0], [p + 50 * u for p, u in zip(given["point"], unit)], 1e-12)
        self.assert_close(found["displaced_directions"][0], given["axis"], 1e-13)
        self.assert_close(product(found["matrix"], found["inverse"]), [[float(i == j) for j in range(4)] for i in range(4)], 1e-13)
        for displacement in ({"matrix": found["matrix"]}, {"orientation": {"quaternion": found["quaternion"]}, "translation": found["translation"]},
                             {"from": {"translation": [0, 0, 0]}, "to": {"matrix": found["matrix"]}}):
            again = self.report("screw", {"displacement": displacement})
            self.assert_close(again["matrix"], found["matrix"], 1e-13)
            self.assert_close(again["screw"]["point"], found["screw"]["point"], 1e-12)

    def test_kinds(self):
        for displacement, kind in (({"translation": [0, 0, 0]}, "identity"), ({"translation": [0, -2, 0]}, "pure_translation"),
                                   ({"screw": {"axis": [0, 1, 0], "angle_deg": 180}}, "half_turn"),
                                   ({"screw": {"axis": [0, 1, 0], "slide": 3}}, "pure_translation"),
                                   ({"screw": {"axis": [0, 1, 0], "angle_deg": 360, "slide": 3, "point": [1, 0, 0]}}, "pure_translation"),
                                   ({"screw": {"axis": [0, 1, 0], "angle_deg": 1e-9}}, "general")):
            with self.subTest(displacement):
                found = self.report("screw", {"displacement": displacement})["screw"]
                self.assertEqual(found["kind"], kind)
                self.assertEqual(found["point"] is None, kind in ("identity", "pure_translation"))
                self.assertEqual(found["axis_defined"], kind != "identity")

    def test_flags(self):
        given = self.report("screw", {"length_unit": "mm", "displacement": {"screw": {"axis": [0, 0, 2], "point": [1, 0, 0], "angle_deg": 90, "slide": 5}},
                                      "points": [[1, 1, 1]]})
        found = self.flags("screw", "--axis", "0,0,2", "--point", "1,0,0", "--angle", 90, "--slide", 5, "--move", "1,1,1", "--unit", "mm")
        self.assertEqual(found, given)
        matrix = ",".join(str(x) for row in found["matrix"] for x in row)
        self.assert_close(self.flags("screw", "--matrix", matrix)["screw"]["point"], [1, 0, 0])
        self.assertEqual(self.flags("screw", "--axis", "0,0,1", "--angle", 90, "--translation", "1,2,3")["translation"], [1, 2, 3])
        self.assertEqual(self.flags("screw", "--translation", "1,2,2")["screw"]["kind"], "pure_translation")
        self.assertIn("Rotation by 90.0000°", run("attitude", "screw", "--matrix", matrix)[1])


class Twist(AttitudeTest):
    def test_there_and_back(self):
        given = {"axis": [1, 2, 6], "point": [60, -20, 0], "rate": 2, "pitch": 5}
        found = self.report("twist", {"length_unit": "mm", "twist": {"screw": given}, "points": [[60, -20, 0]]})
        self.assertEqual(found["screw"]["kind"], "screw")
        self.assertAlmostEqual(found["screw"]["rate"], 2, delta=1e-14)
        self.assertAlmostEqual(found["screw"]["slide_rate"], 10, delta=1e-13)
        self.assertAlmostEqual(found["screw"]["pitch"], 5, delta=1e-13)
        self.assert_close(cross([a - b for a, b in zip(found["screw"]["point"], given["point"])], given["axis"]), [0, 0, 0], 1e-12)
        self.assert_close(found["velocities"][0], [10 * a / math.sqrt(41) for a in given["axis"]], 1e-13)
        again = self.report("twist", {"twist": {"angular_velocity": found["angular_velocity"], "velocity": found["velocities"][0], "at": [60, -20, 0]}})
        self.assert_close(again["screw"]["point"], found["screw"]["point"], 1e-12)

    def test_kinds(self):
        for twist, kind in (({"velocity": [0, 0, 0]}, "rest"), ({"velocity": [0, -2, 0]}, "translation"),
                            ({"angular_velocity": [0, 0, 1], "velocity": [3, 4, 0]}, "rotation"),
                            ({"angular_velocity": [0, 0, 1], "velocity": [3, 4, 5]}, "screw")):
            with self.subTest(twist):
                found = self.report("twist", {"twist": twist})["screw"]
                self.assertEqual(found["kind"], kind)
                self.assertEqual(found["point"] is None, kind in ("rest", "translation"))
                self.assertEqual(found["axis_defined"], kind != "rest")

    def test_flags(self):
        found = self.flags("twist", "--angular-velocity", "0,0,2", "--velocity", "0,2,3", "--at", "4,7,1", "--of", "1,0,0")
        self.assertEqual(self.flags("twist", "--axis", "0,0,5", "--point", "3,7,9", "--rate", 2, "--pitch", 1.5, "--of", "1,0,0"), found)
        self.assertEqual(found["velocities"], [[14, -4, 3]])
        self.assertIn("Instantaneous screw", run("attitude", "twist", "--axis", "0,0,1", "--rate", 1, "--slide-rate", 2)[1])
        self.assertIn("Instantaneous rotation", run("attitude", "twist", "--axis", "0,0,1", "--rate", 1)[1])
        self.assertIn("At rest", run("attitude", "twist", "--velocity", "0,0,0")[1])


class Rates(AttitudeTest):
    EULER = {"euler_deg": [20, 25, 60], "sequence": "zxz"}

    def angles_at(self, time):
        return [20 + 30 * time + 2 * time**2, 25 + 10 * time, 60 - 50 * time + 5 * time**2]

    def test_rates_of_angles_are_derivatives(self):
        step = 1e-4
        first, second = [30, 10, -50], [4, 0, 10]
        found = self.report("rates", {"orientation": self.EULER, "motion": {"euler_rates_deg": first, "euler_accelerations_deg": second}})
        before, now, after = (matrix_of("zxz", self.angles_at(time)) for time in (-step, 0, step))
        for i in range(3):
            for j in range(3):
                self.assertAlmostEqual(found["matrix_first"][i][j], (after[i][j] - before[i][j]) / (2 * step), delta=1e-7)
                self.assertAlmostEqual(found["matrix_second"][i][j], (after[i][j] - 2 * now[i][j] + before[i][j]) / step**2, delta=1e-6)
        self.assert_close(found["given_angles"]["rates_deg"], first, 1e-12)
        self.assert_close(found["given_angles"]["accelerations_deg"], second, 1e-11)
        self.assert_close(found["euler"]["zxz"]["rates_deg"], first, 1e-12)

    def test_every_form_says_the_same(self):
        found = self.report("rates", {"orientation": self.EULER, "motion": {"velocity": [1, 2, 3], "acceleration": [-1, 0.5, 2]}})
        attitude = {"quaternion": found["quaternion"]}
        sequences = found["euler"].items()
        for orientation, motion in (
            (attitude, {key: found["moving"][key] for key in ("velocity", "acceleration")} | {"frame": "moving"}),
            (attitude, {"matrix_first": found["matrix_first"], "matrix_second": found["matrix_second"]}),
            (attitude, {"quaternion_first": found["quaternion_first"], "quaternion_second": found["quaternion_second"]}),
            *(({"euler_deg": each["angles_deg"], "sequence": sequence},
               {"euler_rates_deg": each["rates_deg"], "euler_accelerations_deg": each["accelerations_deg"]}) for sequence, each in sequences),
        ):
            with self.subTest(motion):
                again = self.report("rates", {"orientation": orientation, "motion": motion})
                self.assert_close(again["fixed"]["velocity"], [1, 2, 3], 1e-12)
                self.assert_close(again["fixed"]["acceleration"], [-1, 0.5, 2], 1e-11)

    def test_points(self):
        omega, epsilon, r = [0, 0, 2], [0, 0, 3], [1, 0, 0]
        found = self.report("rates", {"orientation": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}, "motion": {"velocity": omega, "acceleration": epsilon},
                                      "origin": {"position": [5, 5, 5], "velocity": [1, 0, 0]}, "points": [{"position": r, "velocity": [0.5, 0, 0]}]})["points"][0]
        self.assertEqual(found["position"], [6, 5, 5])
        self.assertEqual(found["velocity"], [1.5, 2, 0])
        self.assertEqual(found["acceleration"], [-4, 3 + 2, 0])
        self.assertEqual(found["acceleration_parts"]["coriolis"], [0, 2, 0])

    def test_flags_and_step(self):
        found = self.flags("rates", "--axis", "0,0,1", "--angle", 30, "--velocity", "0,0,1", "--in", "moving", "--step", math.pi / 3, "--point", "1,0,0")
        self.assert_close(found["after_step"]["matrix"], about("z", 90), 1e-15)
        self.assertEqual(len(found["points"]), 1)
        flags = ("--euler", "zxz", "20,25,60", "--euler-rates", "30,10,-50")
        self.assertEqual(self.flags("rates", *flags), self.report("rates", {"orientation": self.EULER, "motion": {"euler_rates_deg": [30, 10, -50]}}))
        output = run("attitude", "rates", *flags)[1]
        self.assertIn("zxz, given", output)
        self.assertIn("angular velocity", output)

    def test_the_lock(self):
        found = self.report("rates", {"orientation": {"euler_deg": [0, 0, 0], "sequence": "zxz"}, "motion": {"velocity": [0, 1, 2]}})
        self.assertTrue(found["euler"]["zxz"]["locked"])
        self.assertAlmostEqual(found["euler"]["zxz"]["velocity_residual"], 1, delta=1e-15)
        self.assertIn("Gimbal lock", run("attitude", "rates", "--euler", "zxz", "0,0,0", "--velocity", "0,1,2")[1])


class HartenbergDenavit(AttitudeTest):
    def transform(self, theta, d, a, alpha, modified):
        def move(x, z):
            return [[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, z], [0, 0, 0, 1]]

        def turn(axis, angle):
            return [row + [0] for row in about(axis, angle)] + [[0, 0, 0, 1]]

        parts = [turn("z", theta), move(0, d), move(a, 0), turn("x", alpha)]
        parts = [*reversed(parts[2:]), *parts[:2]] if modified else parts
        result = parts[0]
        for part in parts[1:]:
            result = product(result, part)
        return result

    def test_chains(self):
        links = [(30, 400, 25, 90), (45, 0, 455, 0), (-60, 10, 0, -90)]
        keys = ("theta_deg", "d", "a", "alpha_deg")
        for form in ("classic", "modified"):
            found = self.report("dh", {"form": form, "links": [dict(zip(keys, link)) for link in links], "points": [[1, 2, 3]]})
            tip = [[float(i == j) for j in range(4)] for i in range(4)]
            for link, shown in zip(links, found["links"]):
                joint = self.transform(*link, form == "modified")
                tip = product(tip, joint)
                self.assert_close(shown["matrix"], joint, 1e-12)
                self.assert_close(shown["frame"], tip, 1e-12)
            self.assert_close(found["tip"]["matrix"], tip, 1e-12)
            self.assert_close(found["points"][0], [row[0] for row in product(tip, [[1], [2], [3], [1]])][:3], 1e-12)
            flags = [word for link in links for word in ("--link", ",".join(map(str, link)))]
            self.assertEqual(self.flags("dh", *flags, "--form", form, "--point", "1,2,3"), found)
            joint = found["links"][0]["matrix"]
            fit = self.report("dh", {"form": form, "displacement": {"matrix": joint}})
            self.assert_close([fit["link"][key] for key in keys], list(links[0]), 1e-12)

    def test_words(self):
        output = run("attitude", "dh", "--link", "30,400,25,90", "--unit", "mm")[1]
        for piece in ("Chain of 1 link", "lengths in mm", "30.0000°", "screw axis"):
            self.assertIn(piece, output)
        missed = run("attitude", "dh", "--matrix", "1,0,0,0, 0,0,-1,5, 0,1,0,6, 0,0,0,1")[1].replace("\n", " ")
        self.assertIn("Four parameters cannot describe it", missed)
