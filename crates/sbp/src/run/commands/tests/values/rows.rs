//! Tests of the effect of a line and of what reads back, a line a row.

use crate::testing::rows;

rows! {
    sbp_val_range: "VS,0" => "error greater than 0", "VC,,,,,,150" => "error 0-100", "VS,5,0" => "error greater than 0; at 0,0,0";
    ranges_are_named_in_the_users_unit: "VD,,,1⏎VU,,,,,.1" => "error at least 0.127", "VU,,,,,.001" => "error at least 0.005";

    sbp_val_va_base: "MX,9⏎VA,,,.75,,,,,0" => "3=0.75; 8=0", "MX,9⏎VA,2,,,,,0" => "1=2; 6=0";
    sbp_val_va_basekeep: "M3,5,5,5⏎VA,0,0,0" => "base 5,5,5; at 0,0,0; 6=5", "M3,5,5,5⏎VA,0,0,0⏎ST" => "at 5,5,5; moves 1";
    va_sets_one_axis_at_a_time: "M3,1,2,3⏎VA,,,.5" => "at 1,2,0.5; moves 1", "VA" => "at 0,0,0; moves 0", "VA,,,0,,,,,,0,,," => "no warning";
    va_a_and_b: "VD,,5⏎VA,,,,4,90,,,,1,2" => "4=4; 5=90; 9=1; 10=2";

    sbp_val_vb_params: "" => "41=0.1; 42=4; 43=1; 44=0.5", "VB,.2,5,2,.25,0,," => "41=0.2; 42=5; 43=2; 44=0.25";
    vb_refuses_what_makes_no_tab: "VB,,0" => "error greater than 0", "VB,-1" => "error 0 or greater", "VB,,,,,1,0" => "error at least 1", "VB,,,,,2" => "error one of 0, 1";

    sbp_val_vc_params: "VC,.5,9,9,2,+,20,3,1,.05,.1,A,9" => "23=0.5; 28=2; 29=3; 141=0.05; 142=0.1; no warning",
        "VC, 6.35, , , 10, 0, 10, 0, 0, 0, 0, Z, 8" => "23=6.35; 28=10; 29=0; no warning";
    vc_overlap: "VC,,,,,,100" => "error less than 100", "VC,,,,,,-1" => "error 0-100", "VC,,,,,,0" => "no warning";
    sbp_val_vc_safez: "" => "28=1", "VC,,,,.5⏎JH" => "at 0,0,.5; last jog";
    sbp_val_vc_safea: "VD,,4⏎MA,-.2⏎JH" => "at 0,0,1,1; 29=1";
    sbp_val_vc_trigger_axis: "VC,,,,,,,,1,,,A" => "no warning", "VC,,,,,,,,1,,,z" => "no warning", "VC,,,,,,,,1,,,B" => "error axis monitored must be one of Z, A";
    sbp_val_vc_trigger_out: "VC,,,,,,,,,,,,3" => "no warning", "VC,,,,,,,,,,,,12" => "no warning", "VC,,,,,,,,,,,,1" => "error one of 3, 5",
        "VC,,,,,,,,,,,,2" => "error one of", "VC,,,,,,,,,,,,4" => "error one of", "VC,,,,,,,,,,,,13" => "error one of", "VC,,,,,,,,1,.05,.1,Z,8" => "141=0.05; 142=0.1";
    plunge_directions: "VC,,,,,x" => "error plunge direction must be one of -, +";

    sbp_val_vd_axes: "VD,,5" => "27=5", "MA,1" => "error A axis not active", "VD,,2" => "error 3-6", "VD,,7" => "error 3-6";
    sbp_val_vd_units: "MX,1⏎VD,,,1" => "1=25.4; 23=6.35; 28=25.4; 71=50.8; 41=2.54; 42=101.6; 43=25.4; 44=12.7; 12=2438.4; 25=1",
        "MX,1⏎VD,,,1⏎VD,,,0" => "1=1; 23=0.25; 28=1; 71=2; 41=0.1; 42=4; 43=1; 44=0.5; 12=96; 25=0; moves 1";
    unit_values_follow_the_unit: "VD,,,1" => "31=15.74803", "VD,,,1⏎VD,,,0" => "31=400";
    ramp_speeds_follow_the_unit: "VD,,,1" => "81=10.16; 85=0.4";
    sbp_val_vd_aunits: "VD,,4,,2⏎MA,5⏎VD,,,1" => "4=5; at 0,0,0,5", "VD,,4⏎MA,1⏎VD,,,1" => "4=25.4", "VD,,4,1,0⏎MA,1" => "4=1; 25=1", "VD,,4,,1⏎MA,25.4⏎VD,,,,0" => "4=1";
    sbp_val_vd_bunits: "VD,,5⏎MB,90⏎VD,,,1" => "5=90", "VD,,5,,,0⏎MB,1⏎VD,,,1" => "5=25.4";
    turning_an_axis_into_degrees_keeps_its_numbers: "VD,,4⏎VS,,,2⏎VU,,,,500⏎VL,,,,,,,-5,5⏎ZT⏎MA,3⏎VD,,4,,2" => "4=3; 9=0; 74=2; 34=500; 17=-5; 18=5; 29=1; 84=0.4",
        "VD,,4⏎MA,3⏎VA,,,,1⏎VD,,4,,2⏎MA,90⏎VD,,4,,0" => "4=90; 9=2";
    sbp_val_vd_console_obs: "VD,,,,,,0" => "no warning", "VD" => "no warning", "VD,  ,,,,,,,,,,, 0, -7500,  11355,  4575" => "no warning";
    sbp_val_vd_version2: "VD,,3,0,0,2,1,0,.1,0,1,1,0,0,8800,4600,0,0,1,7" => "warning order of VD is that of version 3", "VD,,3,0,0,2,1,0,.1,0,1,1,0,0,8800,4600,0,0,1" => "no warning";

    sbp_val_vh_enable: "VH,1" => "error not enabled in VN", "VN,,,1⏎VH,1" => "99=1; no warning", "VH,0,,20,80" => "no warning";
    vh_ranges: "VH,0,,101" => "error 0-100", "VH,0,,,,,11" => "error 1-10", "VH,0,,,,0" => "error greater than 0";

    vi_ranges: "VI,17" => "error 1-16", "VI,0" => "error 1-16", "VI,,,,,Q" => "error one of X, Y, Z, A, B, C", "VI,,,,,X,X,Z,A" => "error Y would have no driver channel", "VD,,4⏎VI,,,,,X,Y,Z,X,,B,C" => "error A would have no driver channel", "VI,,,,,X,Y,Z,X" => "no warning", "VI,,,,,,,,,6" => "error one of 2, 3, 4, 5";

    sbp_val_vl_err: "VL,10,5" => "error low limit of X is above", "VL,100" => "error above its high limit", "VL,,,,,,,,,,5,-5" => "error limit of B";
    vl_as_real_files_write_it: "VL,,,,,&low" => "error &LOW has no value", "&low=-4⏎VL,,,,,&low" => "15=-4; 16=6", "VL,0,96,0,48,-6,6,-6,6,1,-5,5,5" => "19=-5; no warning";

    sbp_val_vn_torch: "VN,,,1" => "99=1", "VN,,,2" => "99=0", "VN,,,5" => "99=0", "VN,,,6" => "error one of";
    sbp_val_vn_inmode: "VN,,,,1" => "91=1", "VN,,,,,2" => "92=2", "VN,,,,5" => "error one of 0, 1, 2, 3, 4";

    sbp_val_vo_params: "VO,1,2,1,0⏎M2,5,0" => "at 7,1,0; moves 1", "VO,1,2,1,0⏎MX,5" => "at 7,0,0", "VO,1,2,1" => "moves 0; at 0,0,0",
        "VO,1,2,1,0⏎M2,5,0⏎VO,2⏎M2,5,0" => "at 5,0,0", "VO,1,2,1⏎MX,5⏎VO,0⏎MX,6" => "at 6,0,0", "VO,3" => "error one of 0, 1, 2";
    sbp_val_vo_display: "VO,1,2,1,0⏎M2,5,0" => "1=7; 2=1";
    sbp_val_vo_reuse: "VO,1,2,1⏎VO,2⏎VO,1⏎MX,5" => "at 7,0,0";
    vo_in_relative_mode_counts_once: "SR⏎VO,1,2⏎MX,5⏎MX,5" => "at 12,0,0", "VO,1,2⏎MX,5⏎VO,2⏎SR⏎MX,1" => "at 6,0,0";

    ramp_speeds_of_a_fresh_machine: "" => "81=0.4; 82=0.4; 83=0.4; 84=0.4; 85=0.4; 86=0.4; 90=0.4";
    sbp_val_vr_rampspeed: "VR,1" => "81=1; 82=1; 83=0.4", "VR,,.5,.6,.7,.8,.9,1,1.1" => "83=0.5; 84=0.6; 85=0.7; 86=0.8; 88=0.9; 89=1; 90=1.1";
    sbp_val_vr_warn: "VR,1.5" => "81=1.5; warning is fast", "VR,.1" => "81=0.1; warning is slow", "VR,.2,1.2" => "no warning", "VD,,,1⏎VR,10.06, 10.06, , , 10.06, 10.06, , , 5.08, 5.08, 100, 3.81, 65, , , 5.08" => "no warning; 81=10.06",
        "VD,,5⏎VR,,,,90" => "85=90; no warning", "VR,0" => "error greater than 0";

    sbp_val_vs: "VS,3,1,2,50,8,4,4,100" => "71=3; 72=3; 73=1; 74=2; 75=50; 76=8; 77=8; 78=4; 79=4; 80=100";
    vs_keeps_what_is_blank: "VS,3,1⏎VS,,.5" => "71=3; 73=0.5", "VS,\"\",\"\",5,6" => "71=2; 74=5; 75=6";
    sbp_val_vs_oldorder: "VS, 1.25, .45, , 2.75, .80" => "71=1.25; 73=0.45; 75=2.75; 76=0.8; warning older order", "VS,1.25,.45,1,2.75,.8" => "no warning", "VS,1.25,,,,.8" => "no warning";
    sbp_val_vs_minspeed: "VS,.05" => "71=0.05; no warning", "VS,.01" => "error step interval divider of VU", "VD,,,1⏎VS,1.27" => "71=1.27", "VD,,,1⏎VS,1.2" => "error at least 1.27",
        "VD,,5⏎VS,,,,.01" => "75=0.01";

    vu_values: "VU,0" => "error other than 0", "VU,157.48,157.48,-157.48" => "33=-157.48", "VU,,,,,.001" => "error at least 0.005", "VU,,,,,,,,,,0" => "error 1-10", "VU,,,,,,,,,,11" => "error 1-10";
    vu_without_shifting_slows_jogs: "VU,,,,,,,,,,,,,,,,1⏎VS,1,1,1,1,17,5" => "warning jogs are limited to 16", "VU,,,,,,,,,,,,,,,,1⏎VS,1,1,1,1,16,5" => "no warning", "VS,1,1,1,1,17,5" => "no warning";
    vu_divider: "VU,,,,,,,,,,,,,,,4" => "150=4", "VU,,,,,,,,,,,,,,,101" => "error 1-100", "VU,,,,,,,,,,,,,,,0" => "error 1-100";
    a_unit_value_is_steps_for_the_users_unit: "VU,400" => "31=400", "VD,,,1⏎VU,16" => "31=16", "VD,,,1⏎VU,16⏎VD,,,0" => "31=406.4", "VD,,5⏎VU,,,,,,,,,13.8889⏎VD,,,1" => "35=13.8889";
    sbp_val_vv: "VV,&a=5" => "&a=5", "VV &a = 5" => "&a=5", "VV,&t=Table Surface" => "&t=Table Surface", "&a=1⏎VV,&a=&a+1" => "&a=2", "VV,5" => "error an assignment is expected", "VV" => "error assignment expected";
}
